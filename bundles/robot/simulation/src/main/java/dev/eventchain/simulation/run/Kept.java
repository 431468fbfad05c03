package dev.eventchain.simulation.run;

import dev.eventchain.simulation.coverage.CoverageRecord;
import java.util.Optional;

/**
 * Records that are kept of a run besides what it is judged by.
 *
 * @param answers true if the log has the answers of outputs to pulses of inputs; in lock-step only
 * @param log receives all messages of the nodes; empty for none
 * @param samples receives what the nodes read and write; empty for none
 * @param coverage receives which values messages have; empty for none
 */
public record Kept(
    boolean answers,
    Optional<MessageLog> log,
    Optional<MessageSamples> samples,
    Optional<CoverageRecord> coverage) {

  /** Nothing else. */
  public static final Kept NOTHING =
      new Kept(false, Optional.empty(), Optional.empty(), Optional.empty());

  /** Returns whether all topics of the nodes have to be received. */
  boolean isOfAllTopics() {
    return log.isPresent() || isOfContents();
  }

  /** Returns whether the contents of all messages are needed. */
  boolean isOfContents() {
    return samples.isPresent() || coverage.isPresent();
  }
}
