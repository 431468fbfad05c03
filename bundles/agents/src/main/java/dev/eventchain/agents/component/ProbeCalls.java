package dev.eventchain.agents.component;

import dev.eventchain.agents.chain.ChainView.Value;
import dev.eventchain.sandbox.ComponentCall;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * Probe calls of a component: usual values twice; each input at its limits, twice in a row for
 * components with state; then two inputs at a time, then all together. Usual values come last,
 * since earlier state must not affect them.
 */
final class ProbeCalls {
  /** Maximal number of calls for pairs: enough for all limits of four numbers. */
  private static final int MOST_PAIRS = 600;

  private final List<Value> inputs;
  private final List<List<ProbeValue>> values;
  private final List<ComponentCall> calls = new ArrayList<>();

  private ProbeCalls(List<Value> inputs, SignalLimits limits, ProbeMessages messages) {
    this.inputs = inputs;
    this.values =
        inputs.stream().map(input -> ProbeValue.of(input, limits.of(input), messages)).toList();
  }

  static List<ComponentCall> of(List<Value> inputs, SignalLimits limits, ProbeMessages messages) {
    ProbeCalls calls = new ProbeCalls(inputs, limits, messages);
    calls.add("usual values", Map.of());
    calls.add("the same values again", Map.of());
    calls.addSingles();
    calls.addPairs();
    calls.addAllTogether();
    calls.add("usual values after all others", Map.of());
    return calls.calls;
  }

  private void addSingles() {
    for (int i = 0; i < inputs.size(); i++) {
      for (int edge = 1; edge < values.get(i).size(); edge++) {
        add(name(i, edge), Map.of(i, edge));
        add(name(i, edge) + " again", Map.of(i, edge));
      }
    }
  }

  // Each pair of inputs gets one limit in turn, so that the maximum leaves no pair out.
  private void addPairs() {
    int end = calls.size() + MOST_PAIRS;
    int edges = values.stream().mapToInt(List::size).max().orElse(0);
    for (int both = 0; both < edges * edges; both++) {
      int first = both / edges;
      int second = both % edges;
      for (int i = 0; i < inputs.size(); i++) {
        for (int j = i + 1; j < inputs.size() && calls.size() < end; j++) {
          if (isEdge(i, first) && isEdge(j, second)) {
            add(name(i, first) + ", " + name(j, second), Map.of(i, first, j, second));
          }
        }
      }
    }
  }

  private boolean isEdge(int input, int edge) {
    return edge > 0 && edge < values.get(input).size();
  }

  private void addAllTogether() {
    int most = values.stream().mapToInt(List::size).max().orElse(0);
    for (int edge = 1; edge < most; edge++) {
      Map<Integer, Integer> edges = new HashMap<>();
      for (int i = 0; i < inputs.size(); i++) {
        edges.put(i, Math.min(edge, values.get(i).size() - 1));
      }
      add("all inputs at edge " + edge, edges);
    }
  }

  private String name(int input, int edge) {
    return inputs.get(input).name() + " is " + values.get(input).get(edge).name();
  }

  /** Adds a call with some inputs, by position, at a limit, and the usual values of the others. */
  private void add(String name, Map<Integer, Integer> edges) {
    Map<String, Object> arguments = new LinkedHashMap<>();
    for (int i = 0; i < inputs.size(); i++) {
      ProbeValue value = values.get(i).get(edges.getOrDefault(i, 0));
      arguments.put(inputs.get(i).name(), value.value());
    }
    calls.add(new ComponentCall(name, arguments));
  }
}
