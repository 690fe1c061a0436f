/* SPDX-License-Identifier: MIT
 * SINEW_API marks the functions and classes that a shared library exports. Everything else is hidden, so an engine's
 * function of the same name cannot replace a call inside the library. C code includes this header too. */
#pragma once

#if defined(_WIN32) && defined(SINEW_SHARED)
#ifdef SINEW_EXPORTS
#define SINEW_API __declspec(dllexport)
#else
#define SINEW_API __declspec(dllimport)
#endif
#elif defined(__GNUC__) && !defined(_WIN32)
#define SINEW_API __attribute__((visibility("default")))
#else
#define SINEW_API
#endif
