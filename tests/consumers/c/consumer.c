/* A third-party program in plain C. It answers the requests in its arguments; without any it tries misuse that must do no harm. */
#include <evenlift/evenlift.h>
#include <pthread.h>
#include <stdio.h>
#include <string.h>

static const char *const square = "{\"polygon\": [[0, 0], [4, 0], [4, 3], [0, 3]], \"settings\": {\"teams\": 2}}";

static void *many_times(void *first) {
  for (int i = 0; i < 50; ++i) {
    char *again = evenlift_run(square);
    const int differs = again == NULL || strcmp(again, first) != 0;
    evenlift_free(again);
    if (differs) return first;
  }
  return NULL;
}

/* The same answer in several threads at once, with a stack of 1 MiB each. */
static int threads_agree(char *first) {
  pthread_t threads[4];
  pthread_attr_t small;
  int wrong = 0;
  pthread_attr_init(&small);
  pthread_attr_setstacksize(&small, 1 << 20);
  for (int i = 0; i < 4; ++i) wrong |= pthread_create(&threads[i], &small, many_times, first);
  for (int i = 0; i < 4 && !wrong; ++i) {
    void *differs;
    wrong |= pthread_join(threads[i], &differs) || differs != NULL;
  }
  pthread_attr_destroy(&small);
  return !wrong;
}

static int is_error(const char *request) {
  char *answer = evenlift_run(request);
  const int error = answer != NULL && strncmp(answer, "{\"error\": ", 10) == 0;
  evenlift_free(answer);
  return error;
}

int main(int count, char **values) {
  for (int i = 1; i < count; ++i) {
    char *answer = evenlift_run(values[i]);
    if (answer == NULL) return 1;
    fputs(answer, stdout);
    evenlift_free(answer);
  }
  if (count > 1) return 0;

  evenlift_free(NULL);
  const char *const bad[] = {NULL, "", "{", "[]", "3", "\xff", "{\"polygon\": [[0, 0]]}", "{\"polygon\": 1e999}"};
  for (size_t i = 0; i < sizeof bad / sizeof *bad; ++i)
    if (!is_error(bad[i])) return 2;
  char *first = evenlift_run(square);
  if (first == NULL || !threads_agree(first)) return 3;
  evenlift_free(first);
  puts("well");
  return 0;
}
