package dev.eventchain.pipeline;

import com.fasterxml.jackson.databind.node.ObjectNode;
import dev.eventchain.agents.AgentResult;
import dev.eventchain.agents.ImplementAgent;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.metamodel.eventchain.EventChain;
import dev.eventchain.metamodel.eventchain.SoftwareNode;
import dev.eventchain.modeler.Modeled;
import dev.eventchain.python.ComponentProbe;
import dev.eventchain.python.Confinement;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;

/** The components of the chain that do not exist yet: {@code components/*.py}. */
final class ImplementStage implements StageWork {

  static final String FOLDER = "components";

  @Override
  public void fingerprint(RunContext run, Fingerprint fingerprint) {
    AgentReport.fingerprint(run, Stage.IMPLEMENT, fingerprint);
    fingerprint
        .addFile(run.file(DesignStage.FILE))
        .addFile(run.project().requirements())
        .addFile(run.project().softwareBase().resolve("components.json"));
  }

  @Override
  public StageResult execute(RunContext run) {
    Path description = run.required(DesignStage.FILE, Stage.DESIGN);
    List<SoftwareNode> missing = run.softwareBase().missing(readChain(run, description));
    List<String> files = new ArrayList<>();
    List<Diagnostic> found = new ArrayList<>();
    List<AgentResult> results = new ArrayList<>();
    if (!missing.isEmpty()) {
      ImplementAgent agent =
          new ImplementAgent(
              run.agent(Stage.IMPLEMENT), new ComponentProbe(run.python(Stage.IMPLEMENT)));
      SourceText text = SourceText.read(description);
      List<Diagnostic> awaited = new ArrayList<>();
      for (SoftwareNode node : missing) {
        run.progress().step(Stage.IMPLEMENT, node.getName());
        Optional<AgentResult> answered =
            ask(() -> agent.implement(text, node.getName(), run.requirements()), awaited);
        if (answered.isPresent()) {
          String file = FOLDER + "/" + node.getName() + ".py";
          run.write(file, answered.get().text());
          files.add(file);
          found.addAll(AgentReport.placed(run, answered.get()));
          results.add(answered.get());
        }
      }
      if (!awaited.isEmpty()) {
        throw new DiagnosticException(DiagnosticException.Reason.WAITING, awaited);
      }
    }
    found.addAll(run.output().removeOthers(FOLDER, files));
    ObjectNode report = AgentReport.of(run, Stage.IMPLEMENT, results);
    if (!missing.isEmpty()) {
      report.put("confinement", Confinement.detect().describe());
      report.put("python", run.python(Stage.IMPLEMENT).version());
    }
    return new StageResult(details(run, missing, results), files, found, report);
  }

  /** A person who is asked for one component may as well be asked for all of them. */
  private static Optional<AgentResult> ask(
      Supplier<AgentResult> question, List<Diagnostic> awaited) {
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

  private static String details(
      RunContext run, List<SoftwareNode> missing, List<AgentResult> results) {
    return missing.isEmpty()
        ? "no component is missing"
        : String.join(", ", missing.stream().map(SoftwareNode::getName).toList())
            + AgentReport.effort(run, results);
  }

  private static EventChain readChain(RunContext run, Path description) {
    Modeled<EventChain> chain = ChainOrigins.direct(run, description);
    if (Diagnostic.anyError(chain.diagnostics())) {
      throw new DiagnosticException(DiagnosticException.Reason.FINDINGS, chain.diagnostics());
    }
    return chain.root();
  }
}
