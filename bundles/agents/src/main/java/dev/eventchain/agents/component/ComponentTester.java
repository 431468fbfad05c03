package dev.eventchain.agents.component;

import dev.eventchain.agents.chain.ChainView;
import dev.eventchain.agents.chain.ChainView.Component;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.Severity;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.documents.DocumentFormat;
import dev.eventchain.project.Requirements;
import dev.eventchain.sandbox.ComponentProbe;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;

/**
 * The tests of a component: calls of {@code execute} with expected results, and properties over
 * ranges of inputs, each with its requirement. A component of any language is called as the chain
 * describes it.
 */
public final class ComponentTester {
  private final SourceText source;
  private final Component component;
  private final ComponentTests tests;
  private final List<Diagnostic> diagnostics;

  private ComponentTester(
      SourceText source, Component component, ComponentTests tests, List<Diagnostic> diagnostics) {
    this.source = source;
    this.component = component;
    this.tests = tests;
    this.diagnostics = List.copyOf(diagnostics);
  }

  /**
   * Reads tests.
   *
   * @param source a file {@code tests/NAME.yaml}
   * @param chain the event-chain description
   * @param component the name of the component in it
   * @param requirements the requirements of the project
   * @throws IllegalArgumentException if the chain has no such component
   */
  public static ComponentTester read(
      SourceText source, SourceText chain, String component, Requirements requirements) {
    return read(source, DocumentFormat.YAML, ChainView.component(chain, component), requirements);
  }

  public static ComponentTester read(
      SourceText source, DocumentFormat format, Component component, Requirements requirements) {
    List<Diagnostic> found = new ArrayList<>();
    ComponentTests tests = ComponentTestsReader.read(source, format, component, found::add);
    ComponentTestsCheck check = new ComponentTestsCheck(component, requirements);
    found.addAll(check.wrong(tests));
    SourceLocation place = source.at(0);
    if (tests.tests().isEmpty() && tests.properties().isEmpty() && found.isEmpty()) {
      String message = "The file contains no test and no property.";
      found.add(Diagnostic.of(ComponentTestsReader.FORMAT, message, place));
    } else if (found.isEmpty()) {
      check.gaps(tests, place).ifPresent(found::add);
    }
    return new ComponentTester(source, component, tests, found);
  }

  /**
   * Returns errors in the tests, each at its place; for tests without errors, warnings about gaps
   * in them.
   */
  public List<Diagnostic> diagnostics() {
    return diagnostics.stream()
        .map(each -> isGap(each) ? each.withSeverity(Severity.WARNING) : each)
        .toList();
  }

  /** Returns the same findings, with gaps as errors. */
  public List<Diagnostic> complaints() {
    return diagnostics;
  }

  private static boolean isGap(Diagnostic finding) {
    return finding.is(TestRules.TESTS_GAP);
  }

  /** A test or a property, with the requirement that it is about. */
  public record Listed(String name, String requirement, SourceLocation place) {}

  /** Returns all tests, then all properties, in the order of the file. */
  public List<Listed> listed() {
    return Stream.concat(
            tests.tests().stream()
                .map(each -> new Listed(each.name(), each.requirement(), each.place())),
            tests.properties().stream()
                .map(each -> new Listed(each.name(), each.requirement(), each.place())))
        .toList();
  }

  /** Returns the number of tests and properties. */
  public int count() {
    return tests.tests().size() + tests.properties().size();
  }

  /**
   * Runs the tests on a component.
   *
   * @param file its Python file
   * @return failed expectations, located in the tests; and problems that prevent calls, located in
   *     the component
   */
  public List<Diagnostic> run(ComponentProbe probe, Path file) {
    return new ComponentTestRun(component, tests).run(probe, file);
  }

  /**
   * Outcome of a run of the tests.
   *
   * @param findings as {@link #run} returns them
   * @param ended whether a call ended the process of the component
   */
  public record Trial(List<Diagnostic> findings, boolean ended) {}

  /** Runs the tests on a component, and tells whether one ends its process. */
  public Trial trial(ComponentProbe probe, Path file) {
    ComponentTestRun run = new ComponentTestRun(component, tests);
    List<Diagnostic> findings = run.run(probe, file);
    return new Trial(findings, run.ended());
  }

  /**
   * Runs the tests on a component that was never called before, such as a manually edited one. If
   * the calls of the first test fail, the other tests are skipped: each might hang.
   *
   * @param file its Python file
   * @return the problems in the calls of the first test, located in the component; if there are
   *     none, as {@link #run}
   */
  public List<Diagnostic> check(ComponentProbe probe, Path file) {
    ComponentTestRun run = new ComponentTestRun(component, tests);
    List<Diagnostic> found = probe.check(file, component.signature(), run.first());
    return found.isEmpty() ? run.run(probe, file) : found;
  }

  /** Returns whether a place is in the file of the tests. */
  boolean holds(SourceLocation place) {
    return place.file().equals(source.name());
  }
}
