package dev.eventchain.simulation.tracing;

import dev.eventchain.simulation.tracing.TraceEvent.ThreadId;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;

/** Activity of ROS 2 nodes in a trace, in the order of time. Times are in ns since 1970. */
final class RosActivity {

  /** A node by its name and its namespace. */
  record Node(String name, String namespace) {

    /** Returns the name with its namespace. */
    String fullName() {
      return (namespace.endsWith("/") ? namespace : namespace + "/") + name;
    }
  }

  /** A subscription of a node. */
  record Subscription(Node node, String topic) {}

  /** A publisher of a node. */
  record Publisher(Node node, String topic) {}

  /** A timer; it is linked with its node after its callback. */
  static final class Timer {
    Node node;
    final long period;

    Timer(long period) {
      this.period = period;
    }
  }

  /** A callback of a subscription or of a timer; the other one is null. */
  record Callback(Subscription subscription, Timer timer) {

    /** Returns the node; null if the trace does not say which it is. */
    Node node() {
      return subscription == null ? timer.node : subscription.node();
    }
  }

  /** An execution of a callback. */
  static final class Execution {
    final Callback callback;
    final ThreadId thread;
    final long start;

    /** The end; 0 while it is not known. */
    long end;

    /** The message that it was called with; null if there is none or it is not known. */
    Take take;

    final List<Publication> publications = new ArrayList<>();

    Execution(Callback callback, ThreadId thread, long start) {
      this.callback = callback;
      this.thread = thread;
      this.start = start;
    }
  }

  /** A message that a node published. */
  static final class Publication {
    final Publisher publisher;
    final ThreadId thread;
    final long time;

    /** The time that the middleware sends with it; 0 if the trace does not have it. */
    long stamp;

    /** The execution that published it; null outside of all callbacks that are known. */
    final Execution execution;

    Publication(Publisher publisher, ThreadId thread, long time, Execution execution) {
      this.publisher = publisher;
      this.thread = thread;
      this.time = time;
      this.execution = execution;
    }
  }

  /** A message that a node took from the middleware. */
  static final class Take {
    final Subscription subscription;
    final ThreadId thread;
    final long time;

    /** The time that the middleware sent with it; 0 if there is none. */
    final long stamp;

    /** The execution of the subscription's callback; null if there was none. */
    Execution execution;

    Take(Subscription subscription, ThreadId thread, long time, long stamp) {
      this.subscription = subscription;
      this.thread = thread;
      this.time = time;
      this.stamp = stamp;
    }
  }

  /** The time of the first event; 0 without any. */
  long begin;

  /** The time of the last event; 0 without any. */
  long end;

  /** The threads in which a callback ended within another one. */
  final Set<ThreadId> mixed = new HashSet<>();

  final List<Node> nodes = new ArrayList<>();
  final List<Publisher> publishers = new ArrayList<>();
  final List<Subscription> subscriptions = new ArrayList<>();
  final List<Execution> executions = new ArrayList<>();
  final List<Publication> publications = new ArrayList<>();
  final List<Take> takes = new ArrayList<>();
}
