package dev.eventchain.pipeline.design;

import dev.eventchain.agents.AgentResult;
import dev.eventchain.agents.ImplementAgent;
import dev.eventchain.agents.component.ComponentTester;
import dev.eventchain.diagnostics.Coverage;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.jsonmodels.Modeled;
import dev.eventchain.model.Signal;
import dev.eventchain.model.eventchain.ComponentImplementation;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.model.eventchain.SoftwareNode;
import dev.eventchain.pipeline.project.Project;
import dev.eventchain.pipeline.results.Answers;
import dev.eventchain.pipeline.run.Stage;
import dev.eventchain.pipeline.stage.ChainSnapshot;
import dev.eventchain.pipeline.stage.ComponentFiles;
import dev.eventchain.pipeline.stage.Fingerprint;
import dev.eventchain.pipeline.stage.RunContext;
import dev.eventchain.pipeline.stage.StageResult;
import dev.eventchain.pipeline.stage.StageWork;
import dev.eventchain.project.ProjectFolder;
import dev.eventchain.sandbox.ComponentProbe;
import dev.eventchain.sandbox.Confinement;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Supplier;
import java.util.regex.Pattern;

/** Implements the missing components of the chain: {@code components/*.py}. */
public final class ImplementStage implements StageWork {
  /** The type of a value that is a message or an array of messages. */
  private static final Pattern MESSAGE_VALUE = Pattern.compile("\"type\"\\s*:\\s*\"\\w+/");

  @Override
  public void fingerprint(RunContext run, Fingerprint fingerprint) {
    AgentReport.fingerprint(run, Stage.IMPLEMENT, fingerprint);
    fingerprint
        .addFile(run.file(ProjectFolder.DESCRIPTION))
        .addRequirements()
        .addFile(run.project().componentsFile())
        .add(run.project().configuration().models("test"))
        .addFiles(TestFiles.ofProject(run.project()));
    if (run.project().catalogue().isPresent()) {
      fingerprint.addFiles(run.project().signalFiles()); // components are called at their limits
    }
    if (hasMessageValues(run)) {
      fingerprint.addMessages(); // their definitions are in the prompts
    }
    if (!TestFiles.ofProject(run.project()).isEmpty()) {
      fingerprint.addFiles(run.project().softwareBaseFiles()).addNode();
      fingerprint.addFiles(testedCode(run));
    }
  }

  /** Returns whether a value of a component is a message or an array of messages. */
  private static boolean hasMessageValues(RunContext run) {
    Path chain = run.file(ProjectFolder.DESCRIPTION);
    return Files.isRegularFile(chain)
        && MESSAGE_VALUE.matcher(SourceText.read(chain).text()).find();
  }

  /** Returns existing components for which people wrote tests, with all that they may import. */
  private static List<Path> testedCode(RunContext run) {
    return run.softwareBase().components().stream()
        .filter(each -> TestFiles.isWritten(run.project(), each.name()))
        .map(each -> each.file().getParent())
        .distinct()
        .flatMap(folder -> Project.existingBelow(folder).stream())
        .toList();
  }

  @Override
  public StageResult execute(RunContext run) {
    Path description = run.required(ProjectFolder.DESCRIPTION, Stage.DESIGN);
    EventChain chain = readChain(run, description);
    List<SoftwareNode> missing = run.softwareBase().missing(chain);
    TestFiles tests = new TestFiles(run, SourceText.read(description));
    Work work = new Work(run, SourceText.read(description), tests);
    StandingDiagnoses.resume(run);
    StandingDiagnoses.store(run);
    if (run.models().correction().components().isEmpty()) {
      work.implement(missing);
    } else {
      work.correct(missing);
    }
    work.found.addAll(tests.ofNoComponent(names(chain.getSoftware())));
    work.testExisting(existing(chain, missing));
    List<String> files = work.removeOthers();
    List<AgentResult> asked = new ArrayList<>(tests.results());
    asked.addAll(work.results);
    Answers report = AgentReport.of(run, Stage.IMPLEMENT, asked);
    if (!missing.isEmpty()) {
      report =
          report.tested(Confinement.detect().describe(), run.python(Stage.IMPLEMENT).version());
    }
    return new StageResult(details(work, missing, asked), files, work.found, report);
  }

  /** Runs all tests, because their number is reported, too, including those of edited files. */
  @Override
  public Optional<Checked> checkEdited(RunContext run, Collection<String> editedOutputs) {
    SourceText description = SourceText.read(run.required(ProjectFolder.DESCRIPTION, Stage.DESIGN));
    EventChain chain = readChain(run, run.file(ProjectFolder.DESCRIPTION));
    List<SoftwareNode> missing = run.softwareBase().missing(chain);
    Work work = new Work(run, description, new TestFiles(run, description));
    missing.forEach(node -> work.test(node.getName()));
    work.testExisting(existing(chain, missing));
    return Optional.of(new Checked(details(work, missing, List.of()), work.found));
  }

  /** Results and findings of the stage so far. */
  private static final class Work {
    private final RunContext run;
    private final SourceText chain;
    private final TestFiles tests;
    private final List<String> files = new ArrayList<>();
    private final List<Diagnostic> found = new ArrayList<>();
    private final List<AgentResult> results = new ArrayList<>();
    private int tested;

    Work(RunContext run, SourceText chain, TestFiles tests) {
      this.run = run;
      this.chain = chain;
      this.tests = tests;
    }

    void implement(List<SoftwareNode> missing) {
      List<Diagnostic> awaited = new ArrayList<>();
      for (SoftwareNode node : missing) {
        run.progress().step(Stage.IMPLEMENT, node.getName());
        if (isKept(node.getName())) {
          keepPresent(node.getName());
          continue;
        }
        Optional<ComponentTester> tester =
            ask(
                () -> tests.written(node.getName()).orElseGet(() -> tests.propose(node.getName())),
                awaited);
        // The component may be requested without its tests while somebody waits for them.
        Optional<AgentResult> answered = ask(() -> implement(node.getName(), tester), awaited);
        if (answered.isPresent() && tester.isPresent()) {
          keep(ComponentFiles.name(node.getName()), answered.get(), tester.get());
        }
      }
      if (!awaited.isEmpty()) {
        throw new DiagnosticException(DiagnosticException.Reason.WAITING, awaited);
      }
    }

    /** Corrects the components that a verdict has sent back; everything else is unchanged. */
    void correct(List<SoftwareNode> missing) {
      for (SoftwareNode node : missing) {
        Optional<AgentResult> correction =
            Optional.ofNullable(run.models().correction().components().get(node.getName()));
        Optional.ofNullable(run.models().correction().tests().get(node.getName()))
            .ifPresent(proposal -> tests.replace(node.getName(), proposal));
        if (correction.isPresent()) {
          keep(
              ComponentFiles.name(node.getName()),
              correction.get(),
              tests.standing(node.getName()));
        } else {
          keepPresent(node.getName());
        }
      }
    }

    private void keepPresent(String component) {
      files.add(ComponentFiles.name(component));
      test(component);
    }

    /** Returns whether a corrected design leaves a component as it is. */
    private boolean isKept(String component) {
      return run.models().correction().kept().contains(component)
          && Files.isRegularFile(run.file(ComponentFiles.name(component)))
          && TestFiles.hasTests(run, component);
    }

    private AgentResult implement(String component, Optional<ComponentTester> tester) {
      List<Signal> signals = run.softwareBase().signals().orElse(List.of());
      return new ImplementAgent(run.models().agent(Stage.IMPLEMENT), probe(), signals)
          .implement(chain, component, run.requirements(), tester);
    }

    private void keep(String file, AgentResult answered, ComponentTester tester) {
      run.write(file, answered.text());
      files.add(file);
      results.add(answered);
      // The answer's tests do not apply to a person's version that is kept.
      if (run.output().isEdited(file)) {
        count(tester, tester.check(probe().ofExisting(), run.file(file)));
      } else {
        count(tester, AgentReport.placed(run, answered));
      }
    }

    /** Runs the current tests on the current component, both possibly edited. */
    void test(String component) {
      run.progress().step(Stage.IMPLEMENT, "tests of " + component);
      ComponentTester tester = tests.standing(component);
      count(tester, tester.check(probe().ofExisting(), run.file(ComponentFiles.name(component))));
    }

    private void count(ComponentTester tester, List<Diagnostic> failed) {
      found.addAll(tester.diagnostics());
      found.addAll(failed);
      tested += Diagnostic.anyError(failed) ? 0 : tester.count();
    }

    /** Tests existing components for which people wrote tests; those of nodes cannot be run. */
    void testExisting(List<SoftwareNode> existing) {
      for (SoftwareNode node : existing) {
        if (isNode(node)) {
          tests.ofNode(node.getName()).ifPresent(found::add);
          continue;
        }
        Optional<ComponentTester> tester = tests.written(node.getName());
        if (tester.isPresent()) {
          run.progress().step(Stage.IMPLEMENT, "tests of " + node.getName());
          Path file = ComponentFiles.of(run, node);
          count(tester.get(), tester.get().run(probe().ofExisting(), file));
        }
      }
    }

    private boolean isNode(SoftwareNode node) {
      return run.softwareBase()
          .find(node.getName())
          .filter(it -> it.implementation() == ComponentImplementation.NODE)
          .isPresent();
    }

    /**
     * Deletes components of an earlier run that this run did not write, and returns their names.
     */
    List<String> removeOthers() {
      found.addAll(run.output().removeOthers(ComponentFiles.FOLDER, files));
      found.addAll(run.output().removeOthers(TestFiles.FOLDER, tests.proposed()));
      List<String> all = new ArrayList<>(files);
      all.addAll(tests.proposed());
      return all;
    }

    private ComponentProbe probe() {
      return new ComponentProbe(run.python(Stage.IMPLEMENT));
    }
  }

  private static List<SoftwareNode> existing(EventChain chain, List<SoftwareNode> missing) {
    return chain.getSoftware().stream().filter(node -> !missing.contains(node)).toList();
  }

  private static List<String> names(List<SoftwareNode> nodes) {
    return nodes.stream().map(SoftwareNode::getName).toList();
  }

  /**
   * Asks a question and collects those that wait for a person, so that all components are requested
   * at once.
   */
  private static <T> Optional<T> ask(Supplier<T> question, List<Diagnostic> awaited) {
    try {
      return Optional.of(question.get());
    } catch (DiagnosticException e) {
      if (e.reason() != DiagnosticException.Reason.WAITING) {
        throw e;
      }
      awaited.addAll(e.diagnostics());
      return Optional.empty();
    }
  }

  private static String details(Work work, List<SoftwareNode> missing, List<AgentResult> asked) {
    Set<String> corrected = work.run.models().correction().components().keySet();
    String implemented =
        missing.isEmpty()
            ? "no component is missing"
            : String.join(", ", corrected.isEmpty() ? names(missing) : corrected)
                + (corrected.isEmpty() ? "" : " corrected after the verdict");
    String tested =
        work.tested == 0 ? "" : ", " + Coverage.counted(work.tested, "component test") + " passed";
    return implemented + tested + AgentReport.effort(work.run, asked);
  }

  private static EventChain readChain(RunContext run, Path description) {
    Modeled<EventChain> chain = ChainSnapshot.direct(run, description);
    if (Diagnostic.anyError(chain.diagnostics())) {
      throw new DiagnosticException(DiagnosticException.Reason.FINDINGS, chain.diagnostics());
    }
    return chain.root();
  }
}
