// SPDX-License-Identifier: MIT
#include "tests/formats/scene_files.h"

namespace sinew::test {

std::string pivots_fbx() {
  return R"fbx(; FBX 7.4.0 project file
FBXHeaderExtension:  {
 FBXHeaderVersion: 1003
 FBXVersion: 7400
}
GlobalSettings:  {
 Version: 1000
 Properties70:  {
  P: "UpAxis", "int", "Integer", "",2
  P: "UpAxisSign", "int", "Integer", "",1
  P: "FrontAxis", "int", "Integer", "",1
  P: "FrontAxisSign", "int", "Integer", "",-1
  P: "CoordAxis", "int", "Integer", "",0
  P: "CoordAxisSign", "int", "Integer", "",1
  P: "UnitScaleFactor", "double", "Number", "",2.54
  P: "TimeMode", "enum", "", "",6
  P: "CustomFrameRate", "double", "Number", "",-1
 }
}
Objects:  {
 Model: 1000, "Model::hip", "LimbNode" {
  Version: 232
  Properties70:  {
   P: "RotationActive", "bool", "", "",1
   P: "InheritType", "enum", "", "",1
   P: "RotationOrder", "enum", "", "",0
   P: "Lcl Translation", "Lcl Translation", "", "A",1,2,3
   P: "Lcl Rotation", "Lcl Rotation", "", "A",10,20,30
   P: "Lcl Scaling", "Lcl Scaling", "", "A",1,1,1
   P: "PreRotation", "Vector3D", "Vector", "",90,0,0
   P: "PostRotation", "Vector3D", "Vector", "",0,45,0
   P: "RotationPivot", "Vector3D", "Vector", "",0,5,0
   P: "RotationOffset", "Vector3D", "Vector", "",0,0,2
   P: "ScalingPivot", "Vector3D", "Vector", "",3,0,0
  }
 }
 Model: 1001, "Model::knee", "LimbNode" {
  Version: 232
  Properties70:  {
   P: "Lcl Translation", "Lcl Translation", "", "A",0,10,0
   P: "Lcl Rotation", "Lcl Rotation", "", "A",0,0,0
   P: "PreRotation", "Vector3D", "Vector", "",0,0,-90
  }
 }
 AnimationStack: 2000, "AnimStack::Take 001", "" {
  Properties70:  {
   P: "LocalStart", "KTime", "Time", "",0
   P: "LocalStop", "KTime", "Time", "",46186158000
  }
 }
 AnimationLayer: 2001, "AnimLayer::BaseLayer", "" {
 }
 AnimationCurveNode: 3000, "AnimCurveNode::R", "" {
  Properties70:  {
   P: "d|X", "Number", "", "A",10
   P: "d|Y", "Number", "", "A",0
   P: "d|Z", "Number", "", "A",0
  }
 }
 AnimationCurve: 4000, "AnimCurve::", "" {
  Default: 10
  KeyVer: 4008
  KeyTime: *3 {
   a: 0,23093079000,46186158000
  }
  KeyValueFloat: *3 {
   a: 10,40,-20
  }
  KeyAttrFlags: *1 {
   a: 4
  }
  KeyAttrDataFloat: *4 {
   a: 0,0,0,0
  }
  KeyAttrRefCount: *1 {
   a: 3
  }
 }
 AnimationCurveNode: 3001, "AnimCurveNode::T", "" {
  Properties70:  {
   P: "d|X", "Number", "", "A",0
   P: "d|Y", "Number", "", "A",10
   P: "d|Z", "Number", "", "A",0
  }
 }
 AnimationCurve: 4001, "AnimCurve::", "" {
  Default: 10
  KeyVer: 4008
  KeyTime: *2 {
   a: 0,46186158000
  }
  KeyValueFloat: *2 {
   a: 10,12
  }
  KeyAttrFlags: *1 {
   a: 4
  }
  KeyAttrDataFloat: *4 {
   a: 0,0,0,0
  }
  KeyAttrRefCount: *1 {
   a: 2
  }
 }
}
Connections:  {
 C: "OO",1000,0
 C: "OO",1001,1000
 C: "OO",2001,2000
 C: "OO",3000,2001
 C: "OO",3001,2001
 C: "OP",3000,1000, "Lcl Rotation"
 C: "OP",3001,1001, "Lcl Translation"
 C: "OP",4000,3000, "d|X"
 C: "OP",4001,3001, "d|Y"
}
)fbx";
}

std::string sail_fbx() {
  return R"fbx(; FBX 7.4.0 project file
FBXHeaderExtension:  {
 FBXHeaderVersion: 1003
 FBXVersion: 7400
}
GlobalSettings:  {
 Version: 1000
 Properties70:  {
  P: "UnitScaleFactor", "double", "Number", "",1
  P: "TimeMode", "enum", "", "",6
 }
}
Objects:  {
 Geometry: 100, "Geometry::sail", "Mesh" {
  Vertices: *12 {
   a: 0,0,0,100,0,0,100,100,0,0,100,0
  }
  PolygonVertexIndex: *4 {
   a: 0,1,2,-4
  }
  GeometryVersion: 124
 }
 Geometry: 101, "Geometry::wind", "Shape" {
  Version: 100
  Indexes: *2 {
   a: 2,3
  }
  Vertices: *6 {
   a: 0,0,50,0,0,25
  }
  Normals: *6 {
   a: 0,0,0,0,0,0
  }
 }
 Model: 200, "Model::boat", "Mesh" {
  Version: 232
  Properties70:  {
   P: "Lcl Translation", "Lcl Translation", "", "A",0,100,0
   P: "GeometricTranslation", "Vector3D", "Vector", "",0,0,10
   P: "GeometricRotation", "Vector3D", "Vector", "",0,90,0
  }
 }
 Model: 201, "Model::flag", "Null" {
  Version: 232
  Properties70:  {
   P: "Lcl Translation", "Lcl Translation", "", "A",0,50,0
  }
 }
 Deformer: 300, "Deformer::shapes", "BlendShape" {
  Version: 100
 }
 Deformer: 301, "SubDeformer::wind", "BlendShapeChannel" {
  Version: 100
  DeformPercent: 0
  FullWeights: *1 {
   a: 100
  }
 }
 AnimationStack: 400, "AnimStack::blow", "" {
  Properties70:  {
   P: "LocalStart", "KTime", "Time", "",0
   P: "LocalStop", "KTime", "Time", "",46186158000
  }
 }
 AnimationLayer: 401, "AnimLayer::BaseLayer", "" {
 }
 AnimationCurveNode: 402, "AnimCurveNode::DeformPercent", "" {
  Properties70:  {
   P: "d|DeformPercent", "Number", "", "A",0
  }
 }
 AnimationCurve: 403, "AnimCurve::", "" {
  Default: 0
  KeyVer: 4008
  KeyTime: *3 {
   a: 0,23093079000,46186158000
  }
  KeyValueFloat: *3 {
   a: 0,100,25
  }
  KeyAttrFlags: *1 {
   a: 4
  }
  KeyAttrDataFloat: *4 {
   a: 0,0,0,0
  }
  KeyAttrRefCount: *1 {
   a: 3
  }
 }
}
Connections:  {
 C: "OO",200,0
 C: "OO",201,200
 C: "OO",100,200
 C: "OO",100,201
 C: "OO",300,100
 C: "OO",301,300
 C: "OO",101,301
 C: "OO",401,400
 C: "OO",402,401
 C: "OP",402,301, "DeformPercent"
 C: "OP",403,402, "d|DeformPercent"
}
)fbx";
}

std::string tower_collada() {
  return R"dae(<?xml version="1.0" encoding="utf-8"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
 <asset><unit name="foot" meter="0.3048"/><up_axis>Z_UP</up_axis></asset>
 <library_geometries><geometry id="g" name="sail"><mesh>
  <source id="p"><float_array id="pa" count="9">0 0 0 2 0 0 0 0 2</float_array><technique_common>
   <accessor source="#pa" count="3" stride="3">
    <param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/></accessor>
  </technique_common></source>
  <vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
  <triangles count="1"><input semantic="VERTEX" source="#v" offset="0"/><p>0 1 2</p></triangles>
 </mesh></geometry></library_geometries>
 <library_visual_scenes><visual_scene id="s">
  <node id="n" name="tower"><translate>0 0 3</translate><instance_geometry url="#g"/></node>
 </visual_scene></library_visual_scenes>
 <scene><instance_visual_scene url="#s"/></scene>
</COLLADA>
)dae";
}

}  // namespace sinew::test
