package dev.eventchain.lsp;

import static org.junit.jupiter.api.Assertions.assertEquals;

import dev.eventchain.fixtures.EditorClient;
import dev.eventchain.fixtures.Projects;
import dev.eventchain.fixtures.Repository;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.time.Instant;
import java.util.List;
import org.eclipse.lsp4j.CodeLens;
import org.eclipse.lsp4j.CodeLensParams;
import org.eclipse.lsp4j.Position;
import org.eclipse.lsp4j.Range;
import org.eclipse.lsp4j.TextDocumentIdentifier;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What is shown above scenarios and chains: how to simulate them, and their last verdict. */
class LensTest {

  private static final String VERDICT =
      """
      {"chain": "radar_aeb", "passed": false, "scenarios": [
        {"name": "stopped-vehicle-50", "tested": true, "passed": true, "criteria": [
          {"text": "no impact", "tested": true, "passed": true,
           "margin": {"value": 3.0145, "unit": "m", "time": 5}},
          {"text": "no braking", "tested": true, "passed": true,
           "margin": {"value": 0.29, "unit": "s", "time": 2}},
          {"text": "it brakes", "tested": true, "passed": true,
           "margin": {"value": 0.5, "unit": "s", "time": 2}}]},
        {"name": "second", "tested": true, "passed": false, "criteria": [
          {"text": "no impact", "tested": true, "passed": true},
          {"text": "it stops", "tested": true, "passed": false,
           "margin": {"value": -2, "unit": "km/h", "time": 5}}]},
        {"name": "third", "tested": false, "passed": false, "criteria": [
          {"text": "it stops", "tested": false, "passed": false}]}]}
      """;

  @TempDir private Path folder;

  private static List<String> titles(TestSession session, Path file) {
    return lenses(session, file).stream().map(each -> each.getCommand().getTitle()).toList();
  }

  private static List<? extends CodeLens> lenses(TestSession session, Path file) {
    CodeLensParams params = new CodeLensParams(new TextDocumentIdentifier(EditorClient.uri(file)));
    return EditorClient.get(session.client.server().getTextDocumentService().codeLens(params));
  }

  @Test
  void aScenarioAndAChainCanBeSimulatedAndShowTheLastVerdict() throws Exception {
    Path example = Repository.ROOT.resolve("examples/radar-aeb");
    Path project = Projects.copy(example, folder.resolve("radar-aeb"));
    Path scenario = project.resolve("scenarios/stopped-vehicle-50.yaml");
    Path chain = project.resolve("model/chain.xmi");
    Path verdict = project.resolve("out/verdict.json");
    Files.deleteIfExists(verdict);
    try (TestSession session = new TestSession(folder.resolve("nothing"))) {
      CodeLens simulate = lenses(session, scenario).get(0);
      assertEquals(List.of("Simulate this scenario"), titles(session, scenario));
      assertEquals("eventchain.simulate", simulate.getCommand().getCommand());
      assertEquals(
          "[\"" + project + "\", \"stopped-vehicle-50\"]",
          simulate.getCommand().getArguments().toString());
      assertEquals(List.of("Simulate all scenarios"), titles(session, chain));
      assertEquals(List.of(), titles(session, project.resolve("bench.yaml")));

      write(verdict, VERDICT);
      String passed = "Passed, smallest margin 3.01 m, 0.29 s";
      assertEquals(passed, titles(session, scenario).get(1));
      assertEquals("Not passed: 1 of 3 scenarios", titles(session, chain).get(1));
      session.client.open(scenario);
      session.client.change(scenario, new Range(new Position(2, 0), new Position(2, 0)), "#");
      assertEquals(passed + " (older: files have changed since)", titles(session, scenario).get(1));
      session.client.change(
          scenario, null, Files.readString(scenario).replace("stopped-vehicle-50", "second"));
      assertEquals(
          "Failed: it stops, margin -2 km/h (older: files have changed since)",
          titles(session, scenario).get(1));
      session.client.close(scenario);
      Path other = Files.writeString(project.resolve("scenarios/third.yaml"), "name: third\n");
      Files.setLastModifiedTime(other, FileTime.from(Instant.now().plusSeconds(60)));
      assertEquals(
          "Not tested: it stops (older: files have changed since)", titles(session, other).get(1));
    }
  }

  @Test
  void aRunThatWasStoppedOrHasNoneOfTheScenarioShowsNothing() throws Exception {
    Path project = Files.createDirectories(folder.resolve("p/scenarios")).getParent();
    Files.writeString(project.resolve("eventchain.yaml"), "name: p\n");
    Path scenario = Files.writeString(project.resolve("scenarios/a.yaml"), "name: a\n");
    try (TestSession session = new TestSession(folder.resolve("nothing"))) {
      for (String none :
          List.of(
              VERDICT,
              "{",
              "[]",
              "",
              "{\"scenarios\": [{\"name\": null}]}",
              "{\"passed\": false, \"stoppedIn\": \"simulate\", \"scenarios\": []}")) {
        write(project.resolve("out/verdict.json"), none);
        assertEquals(List.of("Simulate this scenario"), titles(session, scenario), none);
      }
    }
  }

  private static void write(Path file, String text) throws Exception {
    Files.createDirectories(file.getParent());
    Files.writeString(file, text);
  }
}
