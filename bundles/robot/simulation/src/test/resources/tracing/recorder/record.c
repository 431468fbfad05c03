/* A chain of nodes that leaves the events of ros2_tracing: see README.md. */
#define LTTNG_UST_TRACEPOINT_CREATE_PROBES
#define LTTNG_UST_TRACEPOINT_DEFINE
#include "ros2.h"

#include <pthread.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#define T(EVENT, ...) lttng_ust_tracepoint(ros2, EVENT, __VA_ARGS__)
#define MS 1000000L

/* The last message of each topic, by the time that it carries. */
static volatile int64_t targets, threats;

typedef struct {
  const char *name, *in, *out;
  volatile int64_t *from, *to;
  long phase, period, execution; /* in ns */
  int python; /* without the events of rclcpp */
} Node;

static int cycles = 6, burst = 0;

static int64_t now(clockid_t clock) {
  struct timespec t;
  clock_gettime(clock, &t);
  return t.tv_sec * 1000000000L + t.tv_nsec;
}

static void pause_for(long ns) {
  struct timespec t = {ns / 1000000000L, ns % 1000000000L};
  nanosleep(&t, NULL);
}

static void publish(Node *n, char *o, char *m) {
  if (!n->python) T(rclcpp_publish, m);
  T(rcl_publish, o + 1, m);
  int64_t stamp = now(CLOCK_REALTIME);
  T(rmw_publish, o + 2, m, stamp);
  if (n->to) *n->to = stamp;
}

static void take(Node *n, char *o, char *m, int64_t *seen) {
  if (!n->from || *n->from == *seen) return;
  *seen = *n->from;
  T(rmw_take, o + 4, m, *seen, 1);
  T(rcl_take, m);
  if (n->python) return;
  T(rclcpp_take, m);
  T(callback_start, o + 6, 0);
  T(callback_end, o + 6);
}

static void *run(void *argument) {
  Node *n = argument;
  char *o = malloc(16), *m = malloc(16); /* addresses: the node's objects, and messages */
  int64_t seen = 0;
  T(rcl_node_init, o, o + 15, n->name, "/");
  if (n->out) T(rcl_publisher_init, o + 1, o, o + 2, n->out, 10);
  if (n->in) {
    T(rcl_subscription_init, o + 3, o, o + 4, n->in, 10);
    if (!n->python) {
      T(rclcpp_subscription_init, o + 3, o + 5);
      T(rclcpp_subscription_callback_added, o + 5, o + 6);
    }
  }
  T(rcl_timer_init, o + 7, n->period);
  if (!n->python) {
    T(rclcpp_timer_callback_added, o + 7, o + 8);
    T(rclcpp_timer_link_node, o + 7, o);
  }
  int64_t next = now(CLOCK_MONOTONIC) + 30 * MS + n->phase;
  for (int i = 0; i < cycles;) {
    take(n, o, m, &seen);
    if (now(CLOCK_MONOTONIC) < next) {
      pause_for(MS / 5);
      continue;
    }
    next += n->period;
    i++;
    for (int k = 0; k < burst; k++) T(rcl_take, m); /* more than buffers hold */
    if (!n->python) T(callback_start, o + 8, 0);
    pause_for(n->execution);
    if (n->out && (!n->in || seen)) publish(n, o, m + 1);
    if (!n->python) T(callback_end, o + 8);
  }
  return NULL;
}

int main(int count, char **arguments) {
  if (count > 1) cycles = atoi(arguments[1]);
  if (count > 2) burst = atoi(arguments[2]);
  Node nodes[] = {
    {"radar_driver", NULL, "/radar/target", NULL, &targets, 0, 20 * MS, MS, 0},
    {"radar_tracking", "/radar/target", "/aeb/threat", &targets, &threats, 5 * MS, 20 * MS, MS, 0},
    {"brake_request", "/aeb/threat", "/brake/request", &threats, NULL, 12 * MS, 20 * MS, MS, 0},
    {"collision_warning", "/aeb/threat", "/cluster/collision_warning", &threats, NULL, 15 * MS,
      20 * MS, MS, 1},
  };
  pthread_t threads[4];
  for (int i = 0; i < 4; i++) pthread_create(&threads[i], NULL, run, &nodes[i]);
  for (int i = 0; i < 4; i++) pthread_join(threads[i], NULL);
  return 0;
}
