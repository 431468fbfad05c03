package dev.eventchain.pipeline.design;

import dev.eventchain.agents.component.ComponentTester;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.Severity;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.diagnostics.Suppressions.Suppressed;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.model.eventchain.SoftwareNode;
import dev.eventchain.pipeline.evidence.Evidence;
import dev.eventchain.pipeline.evidence.Evidence.About;
import dev.eventchain.pipeline.evidence.Evidence.Result;
import dev.eventchain.pipeline.stage.ComponentFiles;
import dev.eventchain.pipeline.stage.RunContext;
import dev.eventchain.pipeline.stage.StageOutcome;
import dev.eventchain.project.ProjectFolder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * The results of the tests of components, from the findings of the stage that runs them: a test is
 * passed if the stage came to its end and nothing was found about it, its file or its component.
 */
public final class ComponentTestResults {

  private final RunContext run;
  private final boolean ended;
  private final List<Diagnostic> errors;

  private ComponentTestResults(RunContext run, StageOutcome implemented) {
    this.run = run;
    this.ended = implemented.report().isPresent();
    this.errors =
        Stream.concat(
                implemented.diagnostics().stream(),
                implemented.found().suppressed().stream().map(Suppressed::finding))
            .filter(each -> each.severity() == Severity.ERROR)
            .toList();
  }

  /**
   * Returns the tests of a chain's components, in its order.
   *
   * @param implemented the outcome of the stage IMPLEMENT
   */
  public static List<Evidence.Test> of(RunContext run, EventChain chain, StageOutcome implemented) {
    Path description = run.file(ProjectFolder.DESCRIPTION);
    if (!Files.isRegularFile(description)) {
      return List.of();
    }
    ComponentTestResults results = new ComponentTestResults(run, implemented);
    TestFiles files = new TestFiles(run, SourceText.read(description));
    List<SoftwareNode> missing = run.softwareBase().missing(chain);
    List<Evidence.Test> tests = new ArrayList<>();
    for (SoftwareNode node : chain.getSoftware()) {
      boolean proposed = missing.contains(node) && TestFiles.hasTests(run, node.getName());
      if (proposed || TestFiles.isWritten(run.project(), node.getName())) {
        tests.addAll(results.of(files, node));
      }
    }
    return tests;
  }

  /** Returns the tests of a component; none if they cannot be read, which the stage reports. */
  private List<Evidence.Test> of(TestFiles files, SoftwareNode node) {
    try {
      List<ComponentTester.Listed> listed = files.standing(node.getName()).listed();
      Optional<String> untested = untested(node, listed);
      Map<String, Integer> names = new HashMap<>();
      List<Evidence.Test> tests = new ArrayList<>();
      for (ComponentTester.Listed each : listed) {
        int number = names.merge(each.name(), 1, Integer::sum);
        String name = number == 1 ? each.name() : each.name() + " (" + number + ")";
        tests.add(test(node.getName(), name, each, untested));
      }
      return tests;
    } catch (DiagnosticException | IllegalArgumentException e) {
      return List.of();
    }
  }

  /** Returns why none of the tests of a component says anything; empty if they do. */
  private Optional<String> untested(SoftwareNode node, List<ComponentTester.Listed> listed) {
    if (!ended) {
      return Optional.of("The component tests did not run, or not to their end.");
    }
    String tests = SourceLocation.of(TestFiles.place(run, node.getName())).file();
    Optional<String> component =
        run.softwareBase().find(node.getName()).map(it -> SourceLocation.of(it.file()).file());
    String file = component.orElseGet(() -> generated(node));
    return errors.stream()
        .filter(each -> each.location().file().equals(file) || isOther(each, tests, listed))
        .map(Diagnostic::message)
        .findFirst();
  }

  private String generated(SoftwareNode node) {
    return SourceLocation.of(run.file(ComponentFiles.name(node.getName()))).file();
  }

  /** Returns whether a finding is about the file of tests, but about none of them. */
  private static boolean isOther(
      Diagnostic finding, String tests, List<ComponentTester.Listed> listed) {
    return finding.location().file().equals(tests)
        && listed.stream().noneMatch(each -> isAbout(finding, each));
  }

  private static boolean isAbout(Diagnostic finding, ComponentTester.Listed test) {
    return finding.location().file().equals(test.place().file())
        && finding.location().line() == test.place().line();
  }

  private Evidence.Test test(
      String component, String name, ComponentTester.Listed test, Optional<String> untested) {
    Optional<String> failed =
        errors.stream().filter(each -> isAbout(each, test)).map(Diagnostic::message).findFirst();
    Result result =
        failed.isPresent()
            ? Result.FAILED
            : untested.isPresent() ? Result.NOT_TESTED : Result.PASSED;
    return new Evidence.Test(
        name,
        Optional.of(component),
        test.place(),
        result,
        failed.or(() -> untested).orElse(""),
        0,
        List.of(new About(test.requirement(), result)));
  }
}
