// SPDX-License-Identifier: MIT
#pragma once
/// Names of the public types, for headers that hold them by pointer or reference. It includes nothing but <cstdint>.
#include <cstdint>

namespace sinew {

// Errors and numbers.
enum class ErrorCode;
template <class T>
struct AffineT;
template <class T>
struct TransformT;
template <class T>
struct DualQuatT;
using Affine = AffineT<float>;
using Affined = AffineT<double>;
using Transform = TransformT<float>;
using Transformd = TransformT<double>;
using DualQuat = DualQuatT<float>;
using DualQuatd = DualQuatT<double>;
struct Aabb;
struct JointMatrix;

// Assets.
struct Animation;
class BoneAnimation;
struct Camera;
class Clip;
struct ClipCertificate;
class ClipLibrary;
struct ClipRest;
struct CompiledSkeletonLod;
struct Image;
struct KeyTolerances;
struct Light;
struct Material;
struct Mesh;
struct MeshInstance;
struct MirrorMap;
struct MorphSet;
class PagedClip;
struct PageTable;
struct PoseCorrective;
struct PoseSamples;
struct Primitive;
struct PropertyTable;
struct PropertyTrack;
struct Scene;
struct SceneLook;
struct Skeleton;
struct SkeletonLod;
struct Skin;
struct Texture;
struct VertexInfluences;

// Jobs.
struct AddPoseJob;
struct AimJob;
struct BlendLayer;
struct BlendPosesJob;
struct ChainIkJob;
struct CorrectPoseJob;
struct FlatNormalsJob;
struct HoldFeetJob;
struct JointPaletteJob;
struct LocalToModelJob;
struct MirrorPoseJob;
struct MorphVerticesJob;
class PoseMemory;
struct PoseSpan;
struct RetargetPoseJob;
struct SampleClipJob;
struct SkinCenterOfRotationJob;
struct SkinDualQuaternionJob;
struct SkinLinearJob;
struct SplitPaletteJob;
struct SurfaceNormalsJob;
struct TwoBoneIkJob;
struct VertexInput;
struct VertexOutput;

// Plans and frames.
struct ClipLayer;
struct DeformedPrimitive;
class FrameBuffer;
struct FrameInput;
struct FrameResult;
struct GeometryInput;
class InputCopy;
struct InstanceResult;
class JobThread;
struct JobThreadOptions;
struct Needs;
class Plan;
struct PlanStage;
struct PrimitivePlan;
struct SkinPalette;
enum class Skinning : std::uint8_t;
enum class Stage : std::uint8_t;
struct VertexSource;
struct WorkCounters;

// Time, retargeting, levels of detail.
class EventCursor;
struct FeetMap;
class HeldInput;
class InterpolatedInput;
class PlaybackClock;
struct PlaybackStep;
struct RootMotionParts;
struct SkeletonMap;
struct TwistMap;
enum class UpdateLevel : std::uint8_t;
struct UpdateRates;

// Springs.
class Springs;
struct SpringsContext;
struct SpringsFault;
struct SpringsJob;
struct SpringSettings;
struct SpringSetup;

// Files.
class AssetFile;
struct AssetFileError;
struct AssetFileOptions;
struct ClipFileError;
class GeometryCache;
struct GeometryCacheError;
class GeometryDecoder;
class GeometryPlayer;
struct GeometryTake;
struct ImportedFile;
struct ImportError;
struct ImportIssue;
struct ImportOptions;
struct VrmCharacter;
struct VrmSprings;

}  // namespace sinew
