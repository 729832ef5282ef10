/* evenlift for C and for every language that can call C. One function turns a request into its
 * answer; both are JSON (docs/requests.md).
 *
 *   char *answer = evenlift_run(
 *       "{\"polygon\": [[0, 0], [4, 0], [4, 3], [0, 3]], \"settings\": {\"teams\": 2}}");
 *   puts(answer);
 *   evenlift_free(answer);
 *
 * Link with -levenlift. pkg-config knows the library as evenlift-c; in CMake,
 * find_package(evenlift) defines the target evenlift::c. */
#ifndef EVENLIFT_EVENLIFT_H
#define EVENLIFT_EVENLIFT_H

#if defined(_WIN32)
#if defined(EVENLIFT_BUILDS_LIBRARY)
#define EVENLIFT_API __declspec(dllexport)
#else
#define EVENLIFT_API __declspec(dllimport)
#endif
#else
#define EVENLIFT_API __attribute__((visibility("default")))
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* Returns the answer to a request. Both are JSON texts in UTF-8 that end with a zero byte. The
 * answer has a line feed before its zero byte. The request may be at most 64 MiB long.
 *
 * The answer is JSON whatever bytes the request contains. If the request is invalid or a null
 * pointer, or if there is too little memory, the answer is {"error": {"code", "message", "place"}}.
 * The function returns NULL only if there is not even enough memory for this error.
 *
 * The answer to {"polygon": ..., "settings": ...} has the same bytes as the output of
 * `evenlift place --json`.
 *
 * The function throws no exception, prints nothing and keeps no state, so any number of threads may
 * call it at once. It uses at most about 1 MiB of the stack. The caller frees the answer with
 * evenlift_free(). */
EVENLIFT_API char* evenlift_run(const char* json);

/* Frees an answer of evenlift_run(). NULL has no effect. */
EVENLIFT_API void evenlift_free(char* answer);

#ifdef __cplusplus
}
#endif

#endif
