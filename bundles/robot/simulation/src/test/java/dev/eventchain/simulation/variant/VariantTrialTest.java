package dev.eventchain.simulation.variant;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.Rule;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.simulation.AebProject;
import dev.eventchain.simulation.chain.NodeConfiguration;
import dev.eventchain.simulation.chain.SimulatedChain;
import dev.eventchain.simulation.host.HostRules;
import dev.eventchain.simulation.host.NodeSession;
import dev.eventchain.simulation.host.RunLog;
import dev.eventchain.simulation.judge.ScenarioJudge;
import dev.eventchain.simulation.run.ScenarioRunner;
import dev.eventchain.simulation.scenario.Scenario;
import dev.eventchain.simulation.verdict.VariantReaction;
import dev.eventchain.simulation.verdict.VariantReaction.Kind;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Queue;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests the reaction to processes that end, with nodes that do nothing else. */
class VariantTrialTest {

  private static final String WORKS = "";
  private static final String CRASHES = "by signal 11";
  private static final String KILLED = "by signal 9";
  private static final String RAISES = "by an exception";

  @TempDir Path folder;
  private final Scenario scenario = AebProject.scenario("stopped-vehicle-50");
  private AebProject project;
  private SimulatedChain chain;
  private PassedScenario passed;
  private VariantTrial trial;

  /** Silent nodes, of which each run ends as it is told to. */
  private record Nodes(Queue<String> ends) implements NodeSession {

    @Override
    public JsonNode configure(JsonNode configuration) {
      String how = ends.remove();
      if (!how.isEmpty()) {
        Rule rule = how.equals(RAISES) ? HostRules.NODE_FAILED : HostRules.SIMULATION_PROCESS_ENDED;
        throw new DiagnosticException(
            DiagnosticException.Reason.FINDINGS, Diagnostic.of(rule, how, SourceLocation.NONE));
      }
      return JsonNodeFactory.instance.objectNode();
    }

    @Override
    public List<Outbound> step(long until, List<Inbound> messages) {
      return List.of();
    }

    @Override
    public RunLog finish() {
      return new RunLog(Map.of(), Map.of());
    }
  }

  @BeforeEach
  void driveTheScenarioOnce() throws Exception {
    project = new AebProject(folder);
    chain = project.request(List.of(scenario)).simulatedChain();
    ScenarioJudge judge = new ScenarioJudge(chain, List.of(), true);
    passed = new PassedScenario(runner(WORKS).run(scenario), judge);
    trial = new VariantTrial(List.of(passed), Optional.empty());
  }

  private ScenarioRunner runner(String... ends) {
    NodeConfiguration nodes =
        new NodeConfiguration(chain, project.request(List.of(scenario)).nodePackage());
    return new ScenarioRunner(
        chain, nodes, Optional.empty(), new Nodes(new ArrayDeque<>(List.of(ends))), Map.of());
  }

  private VariantReaction repeated(String without, String with) {
    VariantReaction first = trial.run(runner(CRASHES));
    assertEquals(Kind.ENDED, first.kind());
    assertEquals(CRASHES, first.words());
    return trial.repeat(first, runner(without), runner(with));
  }

  @Test
  void anEndThatComesAgainIsTheSameReaction() {
    VariantReaction reaction = repeated(WORKS, CRASHES);
    assertEquals(Kind.ENDED, reaction.kind());
    assertEquals("stopped-vehicle-50", reaction.scenario());
    assertTrue(reaction.kind().isNoticed());
  }

  @Test
  void anEndThatDoesNotComeAgainProvesNothing() {
    VariantReaction reaction = repeated(WORKS, WORKS);
    assertEquals(Kind.UNPROVED, reaction.kind());
    assertEquals(CRASHES, reaction.words());
    assertFalse(reaction.kind().isNoticed());
  }

  @Test
  void anotherEndProvesNothing() {
    assertEquals(Kind.UNPROVED, repeated(WORKS, KILLED).kind());
  }

  /** A scenario in which a process ends without a defect, too, might have noticed it. */
  @Test
  void whatNoneOfTheOtherScenariosNoticesIsNotKnown() {
    Diagnostic end = Diagnostic.of(HostRules.SIMULATION_PROCESS_ENDED, KILLED, SourceLocation.NONE);
    assertEquals(Kind.UNCHANGED, trial.run(runner(WORKS)).kind());
    trial = new VariantTrial(List.of(passed), Optional.of(end));
    VariantReaction reaction = trial.run(runner(WORKS));
    assertEquals(Kind.UNPROVED, reaction.kind());
    assertEquals(KILLED, reaction.words());
    assertEquals(Kind.RAISED, trial.run(runner(RAISES)).kind());
  }

  /** The machine may end the process of the components as they are, too. */
  @Test
  void anEndOfTheComponentsAsTheyAreProvesNothing() {
    VariantReaction reaction = repeated(KILLED, CRASHES);
    assertEquals(Kind.UNPROVED, reaction.kind());
    assertEquals(CRASHES, reaction.words());
  }

  @Test
  void anotherFailureOfTheComponentsAsTheyAreEndsAll() {
    DiagnosticException end =
        assertThrows(DiagnosticException.class, () -> repeated(RAISES, CRASHES));
    assertEquals(RAISES, end.diagnostics().get(0).message());
  }

  @Test
  void nodesThatWorkAreNotNoticed() {
    assertEquals(Kind.UNCHANGED, trial.run(runner(WORKS)).kind());
  }
}
