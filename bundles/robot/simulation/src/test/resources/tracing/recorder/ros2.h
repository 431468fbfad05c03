#undef LTTNG_UST_TRACEPOINT_PROVIDER
#define LTTNG_UST_TRACEPOINT_PROVIDER ros2
#undef LTTNG_UST_TRACEPOINT_INCLUDE
#define LTTNG_UST_TRACEPOINT_INCLUDE "./ros2.h"

#if !defined(ROS2_H) || defined(LTTNG_UST_TRACEPOINT_HEADER_MULTI_READ)
#define ROS2_H

#include <lttng/tracepoint.h>
#include <stdint.h>

/* An event with one, two or three addresses. */
#define ONE(EVENT, A) \
  LTTNG_UST_TRACEPOINT_EVENT(ros2, EVENT, LTTNG_UST_TP_ARGS(const void *, a), \
    LTTNG_UST_TP_FIELDS(lttng_ust_field_integer_hex(const void *, A, a)))
#define TWO(EVENT, A, B) \
  LTTNG_UST_TRACEPOINT_EVENT(ros2, EVENT, LTTNG_UST_TP_ARGS(const void *, a, const void *, b), \
    LTTNG_UST_TP_FIELDS(lttng_ust_field_integer_hex(const void *, A, a) \
      lttng_ust_field_integer_hex(const void *, B, b)))

LTTNG_UST_TRACEPOINT_EVENT(ros2, rcl_node_init,
  LTTNG_UST_TP_ARGS(const void *, a, const void *, b, const char *, name, const char *, space),
  LTTNG_UST_TP_FIELDS(
    lttng_ust_field_integer_hex(const void *, node_handle, a)
    lttng_ust_field_integer_hex(const void *, rmw_handle, b)
    lttng_ust_field_string(node_name, name)
    lttng_ust_field_string(namespace, space)))

#define ENDPOINT(EVENT, HANDLE, RMW_HANDLE) \
  LTTNG_UST_TRACEPOINT_EVENT(ros2, EVENT, \
    LTTNG_UST_TP_ARGS(const void *, a, const void *, b, const void *, c, const char *, topic, \
      size_t, depth), \
    LTTNG_UST_TP_FIELDS( \
      lttng_ust_field_integer_hex(const void *, HANDLE, a) \
      lttng_ust_field_integer_hex(const void *, node_handle, b) \
      lttng_ust_field_integer_hex(const void *, RMW_HANDLE, c) \
      lttng_ust_field_string(topic_name, topic) \
      lttng_ust_field_integer(size_t, queue_depth, depth)))
ENDPOINT(rcl_publisher_init, publisher_handle, rmw_publisher_handle)
ENDPOINT(rcl_subscription_init, subscription_handle, rmw_subscription_handle)

TWO(rclcpp_subscription_init, subscription_handle, subscription)
TWO(rclcpp_subscription_callback_added, subscription, callback)
TWO(rclcpp_timer_callback_added, timer_handle, callback)
TWO(rclcpp_timer_link_node, timer_handle, node_handle)
TWO(rcl_publish, publisher_handle, message)
ONE(rclcpp_publish, message)
ONE(rcl_take, message)
ONE(rclcpp_take, message)
ONE(callback_end, callback)

LTTNG_UST_TRACEPOINT_EVENT(ros2, rcl_timer_init,
  LTTNG_UST_TP_ARGS(const void *, a, int64_t, period),
  LTTNG_UST_TP_FIELDS(
    lttng_ust_field_integer_hex(const void *, timer_handle, a)
    lttng_ust_field_integer(int64_t, period, period)))

LTTNG_UST_TRACEPOINT_EVENT(ros2, callback_start,
  LTTNG_UST_TP_ARGS(const void *, a, int, intra),
  LTTNG_UST_TP_FIELDS(
    lttng_ust_field_integer_hex(const void *, callback, a)
    lttng_ust_field_integer(int, is_intra_process, intra)))

LTTNG_UST_TRACEPOINT_EVENT(ros2, rmw_publish,
  LTTNG_UST_TP_ARGS(const void *, a, const void *, b, int64_t, stamp),
  LTTNG_UST_TP_FIELDS(
    lttng_ust_field_integer_hex(const void *, rmw_publisher_handle, a)
    lttng_ust_field_integer_hex(const void *, message, b)
    lttng_ust_field_integer(int64_t, timestamp, stamp)))

LTTNG_UST_TRACEPOINT_EVENT(ros2, rmw_take,
  LTTNG_UST_TP_ARGS(const void *, a, const void *, b, int64_t, stamp, int, taken),
  LTTNG_UST_TP_FIELDS(
    lttng_ust_field_integer_hex(const void *, rmw_subscription_handle, a)
    lttng_ust_field_integer_hex(const void *, message, b)
    lttng_ust_field_integer(int64_t, source_timestamp, stamp)
    lttng_ust_field_integer(int, taken, taken)))

#endif

#include <lttng/tracepoint-event.h>
