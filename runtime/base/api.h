/* SPDX-License-Identifier: MIT
 * SINEW_API stands before what a shared library shows. All else is hidden: calls inside the library cannot be replaced
 * by an engine's function of the same name. Also read by C. */
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
