package dev.eventchain.contracts.latency;

import dev.eventchain.model.eventchain.LatencyConstraint;
import java.util.OptionalLong;

/** Facts about the messages that reach a chain from outside. */
public interface Stimuli {

  /** Messages that have just arrived, for what components alone make of them. */
  Stimuli FRESH =
      new Stimuli() {
        @Override
        public OptionalLong interval(String topic) {
          return OptionalLong.of(0);
        }

        @Override
        public long before(String topic, LatencyConstraint constraint) {
          return 0;
        }
      };

  /**
   * Returns the longest time between two messages that arrive on a topic, in ns; empty if there may
   * be any, because some get lost or nothing is known.
   */
  OptionalLong interval(String topic);

  /** Returns the time before the arrival of a message that a constraint counts, in ns. */
  long before(String topic, LatencyConstraint constraint);
}
