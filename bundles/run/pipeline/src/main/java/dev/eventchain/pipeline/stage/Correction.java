package dev.eventchain.pipeline.stage;

import dev.eventchain.agents.AgentResult;
import dev.eventchain.pipeline.run.Stage;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;

/**
 * Corrections by language models after a failed verdict.
 *
 * @param design the corrected design, if it was the cause
 * @param kept the components whose description a corrected design leaves as it is
 * @param tests corrected tests, by their component
 * @param components corrected components, by name
 */
public record Correction(
    Optional<AgentResult> design,
    Set<String> kept,
    Map<String, AgentResult> tests,
    Map<String, AgentResult> components) {

  /** Nothing was corrected. */
  public static final Correction NONE =
      new Correction(Optional.empty(), Set.of(), Map.of(), Map.of());

  /** Copies the collections. */
  public Correction {
    kept = Set.copyOf(kept);
    tests = Map.copyOf(tests);
    components = Map.copyOf(components);
  }

  /** Returns what is left of the correction of a design once the design has been written. */
  public static Correction keeping(Set<String> kept) {
    return new Correction(Optional.empty(), kept, Map.of(), Map.of());
  }

  /** Returns the correction of a design. */
  public static Correction of(AgentResult design, Set<String> kept) {
    return new Correction(Optional.of(design), kept, Map.of(), Map.of());
  }

  /** Returns the correction of a component, and of its tests if these were the cause. */
  public static Correction of(String component, AgentResult code, Optional<AgentResult> tests) {
    return new Correction(
        Optional.empty(),
        Set.of(),
        tests.map(it -> Map.of(component, it)).orElse(Map.of()),
        Map.of(component, code));
  }

  /** Returns whether nothing was corrected. */
  public boolean isEmpty() {
    return design.isEmpty() && components.isEmpty();
  }

  /** Returns whether a stage writes what was corrected. */
  public boolean concerns(Stage stage) {
    return stage == Stage.DESIGN ? design.isPresent() : stage == Stage.IMPLEMENT && !isEmpty();
  }

  /** Returns the stages that depend on what was corrected, in their order. */
  public List<Stage> stages() {
    return design.isPresent()
        ? Stream.of(Stage.values()).filter(stage -> stage != Stage.REPORT).toList()
        : List.of(Stage.IMPLEMENT, Stage.GENERATE, Stage.SIMULATE);
  }
}
