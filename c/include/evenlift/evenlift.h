/* evenlift for C, and for every language that can call C: one function that takes a request as JSON and gives the answer as
 * JSON. docs/requests.md lists the requests and the answers.
 *
 *   char *answer = evenlift_run("{\"polygon\": [[0, 0], [4, 0], [4, 3], [0, 3]], \"settings\": {\"teams\": 2}}");
 *   puts(answer);
 *   evenlift_free(answer);
 *
 * Link with -levenlift (pkg-config evenlift-c, or evenlift::c from find_package(evenlift)). */
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

/* The answer to a request, a JSON text in UTF-8 that ends in a line feed and a zero byte. The request is a JSON text in UTF-8
 * that ends with a zero byte, at most 64 MiB long.
 *
 * Whatever the bytes are, the answer is JSON: a request that is wrong, and one for which there is no memory, get
 * {"error": {"code", "message", "place"}}. A null pointer gets an error, too. The answer is NULL only if there is no memory
 * even for that.
 *
 * The request {"polygon": ..., "settings": ...} is answered with the very bytes that `evenlift place --json` prints.
 *
 * No exception leaves it, it writes nothing, and it keeps nothing: it may be called by any number of threads at the same
 * time. It uses at most about 1 MiB of the stack. The caller owns the answer, and gives it to evenlift_free(). */
EVENLIFT_API char* evenlift_run(const char* json);

/* Frees an answer. NULL is no answer, and nothing happens. */
EVENLIFT_API void evenlift_free(char* answer);

#ifdef __cplusplus
}
#endif

#endif
