package dev.eventchain.workspace;

import java.util.ArrayList;
import java.util.List;

/** Order of components along the flow of data: who writes a topic comes before who reads it. */
final class FlowOrder {

  private FlowOrder() {}

  /** Returns them in that order; in a cycle, in the given one. */
  static List<DescribedNode> of(List<DescribedNode> nodes) {
    List<DescribedNode> open = new ArrayList<>(nodes);
    List<DescribedNode> ordered = new ArrayList<>();
    while (!open.isEmpty()) {
      DescribedNode next =
          open.stream()
              .filter(node -> open.stream().noneMatch(other -> feeds(other, node)))
              .findFirst()
              .orElse(open.get(0));
      open.remove(next);
      ordered.add(next);
    }
    return ordered;
  }

  private static boolean feeds(DescribedNode writer, DescribedNode reader) {
    return !writer.component().equals(reader.component())
        && writer.endpoints().stream()
            .filter(DescribedEndpoint::isOutput)
            .anyMatch(
                output ->
                    reader.endpoints().stream()
                        .anyMatch(
                            input -> !input.isOutput() && input.topic().equals(output.topic())));
  }
}
