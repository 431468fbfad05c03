package dev.eventchain.endtoend;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import dev.eventchain.fixtures.InTurn;
import dev.eventchain.fixtures.Projects;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests of bounds on latencies against what a bench adds, and against what was measured. */
class LatencyBoundTest {

  private static final String CHAIN = "model/chain.xmi";

  @TempDir private Path folder;

  private ProjectCopy pedestrianBrake() throws IOException {
    Projects.copy(
        Program.ROOT.resolve("tests/end-to-end/src/test/resources/pedestrian-brake"), folder);
    return new ProjectCopy(Projects.withoutStrength(folder));
  }

  @Test
  void validationSaysWhatPhasesMayDoAndWhatNoneAvoid() throws IOException {
    ProjectCopy project = pedestrianBrake();
    project.replace(CHAIN, "maximum=\"150\"", "maximum=\"80\"");
    new Program()
        .run("validate", project.path())
        .expect(0)
        .says("warning: 'list_to_brake' allows 80 ms from 'Crossing_Prediction' to 'Brake_Arbiter'")
        .says("but up to 82 ms are possible")
        .says("(waiting + execution: Crossing_Prediction 50 + 10, Brake_Arbiter 20 + 2)");
    project.replace(CHAIN, "maximum=\"80\"", "maximum=\"1\"");
    new Program()
        .run("validate", project.path())
        .expect(1)
        .says("error: 'list_to_brake' allows 1 ms from 'Crossing_Prediction' to 'Brake_Arbiter'")
        .says("but the worst cases alone are 12 ms. [chain.latency.bound]");
  }

  /** Without priorities, both components on the way wait for the two others: 10 + 2 + 2 ms. */
  @Test
  void componentsOnOneProcessorWaitForEachOther() throws IOException {
    ProjectCopy project = pedestrianBrake();
    project.replace(CHAIN, "maximum=\"150\"/>", "maximum=\"80\"/><processors name=\"ecu\"/>");
    for (String name : List.of("Crossing_Prediction", "Brake_Arbiter", "Crossing_Warning")) {
      String component = "<software name=\"" + name + "\"";
      project.replace(CHAIN, component, component + " mappedTo=\"//@processors.0\"");
    }
    new Program()
        .run("validate", project.path())
        .expect(0)
        .says("but up to 98 ms are possible")
        .says("(waiting + execution: Crossing_Prediction 50 + 14, Brake_Arbiter 20 + 14)")
        .says("nothing else runs on the processors");
    project.replace(CHAIN, "worstCaseExecutionTime=\"10.0\"", "worstCaseExecutionTime=\"44.0\"");
    new Program()
        .run("validate", project.path())
        .expect(1)
        .says("error: The components on 'ecu' need 102 %")
        .says("[chain.processor.overloaded]");
  }

  /** No prompt shows them, so that the recorded answers still hold. */
  @InTurn
  @Test
  void transportTimesOfExistingSoftwareAreAddedToADesign() throws IOException {
    ProjectCopy project = ProjectCopy.of("aeb", folder);
    String topic = "\"topic\": \"/scan\",";
    project.replace(
        "software-base/components.json", topic, topic + " \"worst_case_transport_time\": 2.5,");
    new Program().run("design", project.path()).expect(0);
    new Program().run("model", project.path()).expect(0);
    String chain = Files.readString(folder.resolve("aeb/out/chain.xmi"));
    assertTrue(chain.contains("worstCaseTransportTime=\"2.5\""), chain);
  }

  @InTurn
  @Test
  void latencyOfASensorIsPartOfTheBoundWhereItCounts() throws IOException {
    ProjectCopy project = pedestrianBrake();
    project.replace(
        "bench.yaml",
        "latency_ms: 40\n",
        "latency_ms: 40\n    latency_counts_in: [list_to_brake]\n");
    project.replace(CHAIN, "maximum=\"150\"", "maximum=\"115\"");
    project
        .run()
        .expect(0)
        .says("warning: 'list_to_brake' allows 115 ms, but with what passes before")
        .says("'Crossing_Prediction' starts up to 122 ms are possible")
        .says("PASSED");
    JsonNode bound =
        new ObjectMapper().readTree(folder.resolve("out/latency-bounds.json").toFile()).get(1);
    assertEquals("list_to_brake", bound.path("constraint").asText());
    assertEquals(115.0, bound.path("maximum").asDouble());
    assertEquals(122.0, bound.path("bound").asDouble());
    assertEquals(40.0, bound.path("before").asDouble());
    JsonNode first = bound.path("parts").get(0);
    assertEquals("Crossing_Prediction", first.path("component").asText());
    assertEquals(25.0, first.path("saved").asDouble());
    assertEquals(43.0, first.path("largest").asDouble());
    assertEquals(112.0, bound.path("aligned").path("bound").asDouble());
    assertEquals(10.0, bound.path("aligned").path("releases").get(1).path("phase").asDouble());
    assertEquals(111.736, bound.path("measured").path("longest").asDouble());
  }

  /** Executed ten times a second, the brake may come 97 ms later than it did in this scenario. */
  @InTurn
  @Test
  void vehicleThatStopsByLuckIsDrivenWithItsBound() throws IOException {
    ProjectCopy project = ProjectCopy.of("radar-aeb", folder);
    String described = "until nothing is approached.\"";
    project.replace(CHAIN, described + " frequency=\"50.0\"", described + " frequency=\"10.0\"");
    String json = described + ",\n    \"frequency\": ";
    project.replace("software-base/components.json", json + "50.0", json + "10.0");
    project.replace(CHAIN, "maximum=\"100.0\"", "maximum=\"130.0\"");
    String scenario = "scenarios/stopped-vehicle-50.yaml";
    project.replace(scenario, "speed_kmh: 50\n", "speed_kmh: 70\n");
    project.replace(scenario, "gap_m: 80", "gap_m: 120");
    project.replace(
        scenario, "eventually[0, 0.2] /brake/request", "eventually[0, 0.4] /brake/request");
    new Program()
        .run("run", project.path(), "--strength")
        .says("passed  stopped-vehicle-50")
        .says("Scenario stopped-vehicle-50 passes with a latency of 27 ms, as measured; with the")
        .says("124 ms that other phases of the timers make possible, 1.9 m later at 70 km/h, it")
        .says("ends with an impact at 14.1 km/h. [simulation.latency.at-bound]");
    String page = Files.readString(folder.resolve("radar-aeb/out/report.html"));
    assertTrue(page.contains("\"impact\":3.9097"), page);
  }

  private void withoutSafeValues(String file, String pattern) throws IOException {
    Path path = folder.resolve(file);
    Files.writeString(path, Files.readString(path).replaceAll(pattern, ""));
  }

  /** A node that gets no input publishes nothing, so that its last output stays in force. */
  @InTurn
  @Test
  void timeAboveItsBoundIsADefectOfTheModel() throws IOException {
    ProjectCopy project = pedestrianBrake();
    project.replace(
        CHAIN,
        "</eventchain:EventChain>",
        "<latencyConstraints name=\"target_age\" kind=\"DATA_AGE\" first=\"//@software.1\""
            + " last=\"//@software.1\" maximum=\"150\"/></eventchain:EventChain>");
    withoutSafeValues(CHAIN, " safeValue=\"[^\"]*\"");
    withoutSafeValues("software-base/components.json", ", \"safe_value\": \"[^\"]*\"");
    project
        .run()
        .expect(1)
        .says("warning: 'target_age' took 2")
        .says(
            "in 'camera-fails', but by the numbers of the model 62 ms are the most (waiting +"
                + " execution: before the first one 60, Brake_Arbiter 0 + 2)."
                + " [simulation.latency.above-bound]");
  }
}
