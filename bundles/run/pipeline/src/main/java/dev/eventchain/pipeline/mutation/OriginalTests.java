package dev.eventchain.pipeline.mutation;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.simulation.VariantSimulation;
import java.nio.file.Path;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.BiFunction;

/**
 * Tests of the components as they are, which must pass. Where their process ends each time, these
 * tests tell nothing about mutants.
 */
final class OriginalTests {

  private final BiFunction<String, Path, Optional<TestFailure>> test;
  private final Map<String, Diagnostic> ended = new TreeMap<>();

  /**
   * Creates them.
   *
   * @param test runs the tests of a component with a file
   */
  OriginalTests(BiFunction<String, Path, Optional<TestFailure>> test) {
    this.test = test;
  }

  /**
   * Runs the tests of a component, again where the process ends: the machine may have ended it.
   *
   * @param file a copy of its file
   * @param place that file
   * @throws dev.eventchain.diagnostics.DiagnosticException FINDINGS, {@code mutation.unproved}: a
   *     test fails
   */
  void run(String component, Path file, SourceLocation place) {
    Optional<TestFailure> failure = test.apply(component, file);
    for (int i = 0; i < VariantSimulation.REPETITIONS && isEnd(failure); i++) {
      failure = test.apply(component, file);
    }
    if (isEnd(failure)) {
      ended.put(component, failure.get().finding().withLocation(place));
    } else if (failure.isPresent()) {
      throw TestFailure.withoutDefect(failure.get().finding());
    }
  }

  private static boolean isEnd(Optional<TestFailure> failure) {
    return failure.map(TestFailure::ended).orElse(false);
  }

  /** Returns whether the tests of a component tell something. */
  boolean tells(String component) {
    return !ended.containsKey(component);
  }

  /** Returns why the tests of one of some components tell nothing; empty if all do. */
  Optional<String> untold(Collection<String> components) {
    return components.stream()
        .filter(ended::containsKey)
        .map(component -> ended.get(component).message())
        .findFirst();
  }

  /** Returns the findings about tests that tell nothing. */
  List<Diagnostic> ends() {
    return ended.entrySet().stream()
        .map(
            each ->
                SurvivorFindings.ofOriginal(
                    Diagnostic.of(
                        each.getValue().kind(),
                        "in the tests of " + each.getKey() + ": " + each.getValue().message(),
                        each.getValue().location())))
        .toList();
  }
}
