package dev.eventchain.pipeline.design;

import dev.eventchain.agents.AgentResult;
import dev.eventchain.agents.TestAgent;
import dev.eventchain.agents.component.ComponentTester;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.NearestName;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.documents.Document;
import dev.eventchain.documents.DocumentFormat;
import dev.eventchain.documents.JsonLayout;
import dev.eventchain.documents.YamlLayout;
import dev.eventchain.jsonmodels.JsonDocument;
import dev.eventchain.pipeline.project.Project;
import dev.eventchain.pipeline.run.Stage;
import dev.eventchain.pipeline.stage.RunContext;
import dev.eventchain.project.ProjectFolder;
import dev.eventchain.project.ProjectLayout;
import dev.eventchain.project.ProjectSettings;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Optional;

/**
 * Tests of components: files {@code tests/NAME.yaml} of the project, or for missing components
 * without one, proposals of a language model in {@code out/tests}.
 */
public final class TestFiles {
  static final String FOLDER = ProjectLayout.TESTS;
  private static final String SUFFIX = ".yaml";

  private final RunContext run;
  private final SourceText chain;
  private final List<String> proposed = new ArrayList<>();
  private final List<AgentResult> results = new ArrayList<>();

  /**
   * Creates the tests of a run.
   *
   * @param chain the description of the chain
   */
  public TestFiles(RunContext run, SourceText chain) {
    this.run = run;
    this.chain = chain;
  }

  /** Returns the tests that people wrote. */
  public static List<Path> ofProject(Project project) {
    Path folder = project.folder().resolve(FOLDER);
    return Files.isDirectory(folder)
        ? ProjectFolder.below(folder).stream()
            .filter(file -> file.toString().endsWith(SUFFIX))
            .toList()
        : List.of();
  }

  /** Returns the tests that people wrote for a component. */
  Optional<ComponentTester> written(String component) {
    return isWritten(run.project(), component)
        ? Optional.of(read(file(run.project(), component), component))
        : Optional.empty();
  }

  /** Returns the files of all tests, those that people wrote and those that a run proposed. */
  public static List<Path> all(RunContext run) {
    List<Path> files = new ArrayList<>(ofProject(run.project()));
    files.addAll(Project.existingBelow(run.file(FOLDER)));
    return files;
  }

  /** Returns whether there are tests of a component. */
  public static boolean hasTests(RunContext run, String component) {
    return isWritten(run.project(), component)
        || Files.isRegularFile(run.file(FOLDER + "/" + component + SUFFIX));
  }

  /** Returns whether people wrote tests for a component. */
  static boolean isWritten(Project project, String component) {
    return Files.isRegularFile(file(project, component));
  }

  private static Path file(Project project, String component) {
    return project.folder().resolve(FOLDER).resolve(component + SUFFIX);
  }

  /** Proposes tests of a component, which people may edit. */
  ComponentTester propose(String component) {
    AgentResult proposal =
        new TestAgent(run.models().agent(Stage.IMPLEMENT, "test"))
            .propose(chain, component, run.requirements());
    replace(component, proposal);
    String name = FOLDER + "/" + component + SUFFIX;
    proposed.add(name);
    return read(run.file(name), component);
  }

  /**
   * Returns the tests by which a component was implemented in this run or an earlier one.
   *
   * @throws DiagnosticException if there are none any more
   */
  public ComponentTester standing(String component) {
    String name = FOLDER + "/" + component + SUFFIX;
    return written(component)
        .orElseGet(
            () -> {
              proposed.add(name);
              return read(run.file(name), component);
            });
  }

  /** Returns the file of a component's tests: what people wrote, or what a run proposed. */
  static Path place(RunContext run, String component) {
    return isWritten(run.project(), component)
        ? file(run.project(), component)
        : run.file(FOLDER + "/" + component + SUFFIX);
  }

  /** Returns the tests that were proposed for a component, in JSON. */
  String proposal(String component) {
    SourceText text = SourceText.read(run.file(FOLDER + "/" + component + SUFFIX));
    return JsonLayout.of(
        Document.parse(text, DocumentFormat.YAML, ProjectSettings.RULES, problem -> {}).root());
  }

  /** Reads tests that were proposed and not written yet. */
  ComponentTester read(AgentResult proposal, String component) {
    SourceText text = SourceText.of(FOLDER + "/" + component + ".json", proposal.text());
    return ComponentTester.read(text, chain, component, run.requirements());
  }

  /** Replaces the proposed tests of a component. */
  void replace(String component, AgentResult proposal) {
    results.add(proposal);
    String name = FOLDER + "/" + component + SUFFIX;
    run.write(name, YamlLayout.of(JsonDocument.parse(SourceText.of(name, proposal.text())).root()));
  }

  private ComponentTester read(Path file, String component) {
    ComponentTester tests =
        ComponentTester.read(SourceText.read(file), chain, component, run.requirements());
    if (Diagnostic.anyError(tests.diagnostics())) {
      throw new DiagnosticException(DiagnosticException.Reason.FINDINGS, tests.diagnostics());
    }
    return tests;
  }

  /** Returns findings about tests of unknown components, which are not run. */
  List<Diagnostic> ofNoComponent(Collection<String> components) {
    return ofProject(run.project()).stream()
        .filter(file -> !components.contains(name(file)))
        .map(
            file ->
                Diagnostic.of(
                        DesignRules.COMPONENT_TESTS_UNUSED,
                        "The chain has no component '%s', so these tests are not run."
                            .formatted(name(file)),
                        SourceLocation.of(file))
                    .withHint(NearestName.hint(name(file), components)))
        .toList();
  }

  /** Returns the finding about tests of a node that is there as it is, which are not run. */
  Optional<Diagnostic> ofNode(String component) {
    return isWritten(run.project(), component)
        ? Optional.of(
            Diagnostic.of(
                    DesignRules.COMPONENT_TESTS_UNUSED,
                    "'%s' is a node as it is, which no test can call, so these tests are not run."
                        .formatted(component),
                    SourceLocation.of(file(run.project(), component)))
                .withHint("Delete the file; scenarios test a node, together with the others."))
        : Optional.empty();
  }

  private static String name(Path file) {
    String name = file.getFileName().toString();
    return name.substring(0, name.length() - SUFFIX.length());
  }

  /** Returns the proposed files. */
  List<String> proposed() {
    return List.copyOf(proposed);
  }

  /** Returns the results of the agents that wrote them. */
  List<AgentResult> results() {
    return List.copyOf(results);
  }
}
