package dev.eventchain.pipeline.stage;

import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/**
 * Account of a failed verdict, as language models are told about it. It outlives the runs of the
 * scenarios, since a person who answers prompts needs several commands for one correction.
 *
 * @param anyFailed whether there is a scenario that failed by a criterion, or lacks an output
 * @param path the components whose outputs can reach what failed, in chain order
 * @param text the failed criteria, with inputs and outputs of these components
 * @param texts the same with those of one component, by its name
 */
public record FailedVerdict(
    boolean anyFailed, List<String> path, String text, Map<String, String> texts) {

  /** Copies the collections. */
  public FailedVerdict {
    path = List.copyOf(path);
    texts = new TreeMap<>(texts);
  }
}
