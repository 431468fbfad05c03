package dev.eventchain.simulation.tracing;

import dev.eventchain.simulation.tracing.RosActivity.Execution;
import dev.eventchain.simulation.tracing.RosActivity.Node;
import dev.eventchain.simulation.tracing.RosActivity.Publication;
import dev.eventchain.simulation.tracing.RosActivity.Publisher;
import dev.eventchain.simulation.tracing.RosActivity.Subscription;
import dev.eventchain.simulation.tracing.RosActivity.Take;
import dev.eventchain.simulation.tracing.RosActivity.Timer;
import dev.eventchain.simulation.tracing.TraceEvent.Handle;
import dev.eventchain.simulation.tracing.TraceEvent.ThreadId;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashMap;
import java.util.Map;
import java.util.Objects;

/**
 * Reads the activity of nodes from the events of ros2_tracing, in the order of time.
 *
 * <p>Objects are known by their addresses, of which the last one counts. What a thread publishes
 * between the start and the end of a callback belongs to that callback; a callback of a
 * subscription was called with what its thread has taken for it right before.
 */
final class ActivityReader {

  private static final String PREFIX = "ros2:";

  private final RosActivity activity = new RosActivity();
  private final Map<Handle, Node> nodes = new HashMap<>();
  private final Map<Handle, Publisher> publishers = new HashMap<>();
  private final Map<Handle, Subscription> subscriptions = new HashMap<>();

  /** The same subscriptions by the objects of the middleware, and by those of rclcpp. */
  private final Map<Handle, Subscription> ofMiddleware = new HashMap<>();

  private final Map<Handle, Subscription> ofClient = new HashMap<>();
  private final Map<Handle, Timer> timers = new HashMap<>();
  private final Map<Handle, RosActivity.Callback> callbacks = new HashMap<>();

  /** The callbacks that threads execute, the innermost first. */
  private final Map<ThreadId, Deque<Execution>> running = new HashMap<>();

  /** The last messages that threads have taken, and published. */
  private final Map<ThreadId, Take> taken = new HashMap<>();

  private final Map<ThreadId, Publication> published = new HashMap<>();

  /** Reads the next event; those of other instrumentation are skipped. */
  void read(TraceEvent event) {
    activity.begin = activity.begin == 0 ? event.time() : activity.begin;
    activity.end = Math.max(activity.end, event.time());
    if (!event.name().startsWith(PREFIX)) {
      return;
    }
    switch (event.name().substring(PREFIX.length())) {
      case "rcl_node_init" -> node(event);
      case "rcl_publisher_init" -> publisher(event);
      case "rcl_subscription_init" -> subscription(event);
      case "rclcpp_subscription_init" ->
          put(ofClient, event.handle("subscription"), subscriptions, "subscription_handle", event);
      case "rclcpp_subscription_callback_added" -> subscriptionCallback(event);
      case "rcl_timer_init" ->
          timers.put(event.handle("timer_handle"), new Timer(event.number("period")));
      case "rclcpp_timer_callback_added" -> timerCallback(event);
      case "rclcpp_timer_link_node" -> link(event);
      case "callback_start" -> start(event);
      case "callback_end" -> end(event);
      case "rcl_publish" -> publish(event);
      case "rmw_publish" -> stamp(event);
      case "rmw_take" -> take(event);
      default -> {
        // Other events of ROS 2 say nothing about times.
      }
    }
  }

  /** Returns what was read. */
  RosActivity activity() {
    return activity;
  }

  private void node(TraceEvent event) {
    Node node = new Node(event.text("node_name"), event.text("namespace"));
    nodes.put(event.handle("node_handle"), node);
    activity.nodes.add(node);
  }

  private void publisher(TraceEvent event) {
    Node node = nodes.get(event.handle("node_handle"));
    if (node != null) {
      Publisher publisher = new Publisher(node, event.text("topic_name"));
      publishers.put(event.handle("publisher_handle"), publisher);
      activity.publishers.add(publisher);
    }
  }

  private void subscription(TraceEvent event) {
    Node node = nodes.get(event.handle("node_handle"));
    if (node != null) {
      Subscription subscription = new Subscription(node, event.text("topic_name"));
      subscriptions.put(event.handle("subscription_handle"), subscription);
      ofMiddleware.put(event.handle("rmw_subscription_handle"), subscription);
      activity.subscriptions.add(subscription);
    }
  }

  private static <T> void put(
      Map<Handle, T> target, Handle key, Map<Handle, T> source, String field, TraceEvent event) {
    T value = source.get(event.handle(field));
    if (value != null) {
      target.put(key, value);
    }
  }

  private void subscriptionCallback(TraceEvent event) {
    Subscription subscription = ofClient.get(event.handle("subscription"));
    if (subscription != null) {
      callbacks.put(event.handle("callback"), new RosActivity.Callback(subscription, null));
    }
  }

  private void timerCallback(TraceEvent event) {
    Timer timer = timers.get(event.handle("timer_handle"));
    if (timer != null) {
      callbacks.put(event.handle("callback"), new RosActivity.Callback(null, timer));
    }
  }

  private void link(TraceEvent event) {
    Timer timer = timers.get(event.handle("timer_handle"));
    Node node = nodes.get(event.handle("node_handle"));
    if (timer != null && node != null) {
      timer.node = node;
    }
  }

  private void start(TraceEvent event) {
    RosActivity.Callback callback = callbacks.get(event.handle("callback"));
    Execution execution = new Execution(callback, event.threadId(), event.time());
    stack(event).push(execution);
    if (callback == null) {
      return;
    }
    activity.executions.add(execution);
    Take last = taken.get(event.threadId());
    boolean isCalledWithIt =
        last != null
            && last.execution == null
            && callback.subscription() != null
            && Objects.equals(last.subscription, callback.subscription())
            && event.number("is_intra_process") == 0;
    if (isCalledWithIt) {
      execution.take = last;
      last.execution = execution;
    }
  }

  private Deque<Execution> stack(TraceEvent event) {
    return running.computeIfAbsent(event.threadId(), it -> new ArrayDeque<>());
  }

  /** Ends the innermost execution of the callback; those within it have lost their end. */
  private void end(TraceEvent event) {
    RosActivity.Callback callback = callbacks.get(event.handle("callback"));
    Deque<Execution> stack = stack(event);
    boolean runs = stack.stream().anyMatch(it -> Objects.equals(it.callback, callback));
    if (runs && !Objects.equals(stack.element().callback, callback)) {
      activity.mixed.add(event.threadId());
    }
    while (runs) {
      Execution last = stack.pop();
      if (Objects.equals(last.callback, callback)) {
        last.end = event.time();
        return;
      }
    }
  }

  private void publish(TraceEvent event) {
    Publisher publisher = publishers.get(event.handle("publisher_handle"));
    if (publisher == null) {
      published.remove(event.threadId());
      return;
    }
    Execution innermost = stack(event).peek();
    Execution execution = innermost == null || innermost.callback == null ? null : innermost;
    Publication publication = new Publication(publisher, event.threadId(), event.time(), execution);
    if (execution != null) {
      execution.publications.add(publication);
    }
    activity.publications.add(publication);
    published.put(event.threadId(), publication);
  }

  /** Adds the time that the middleware sends with a message; older releases do not record it. */
  private void stamp(TraceEvent event) {
    Publication publication = published.remove(event.threadId());
    if (publication != null) {
      publication.stamp = event.number("timestamp");
    }
  }

  private void take(TraceEvent event) {
    Subscription subscription = ofMiddleware.get(event.handle("rmw_subscription_handle"));
    if (subscription != null && event.number("taken") != 0) {
      Take take =
          new Take(subscription, event.threadId(), event.time(), event.number("source_timestamp"));
      taken.put(event.threadId(), take);
      activity.takes.add(take);
    }
  }
}
