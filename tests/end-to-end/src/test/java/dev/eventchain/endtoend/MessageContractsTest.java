package dev.eventchain.endtoend;

import static org.junit.jupiter.api.Assertions.assertFalse;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests the contracts between the components of a project and the vehicle. */
class MessageContractsTest {

  private static final Path CASES =
      Program.ROOT.resolve("bundles/chain/contracts/src/test/resources/cases");

  @TempDir Path folder;

  @Test
  void qualityOfServiceThatStarvesASubscriberIsFoundAtTheSubscriber() throws IOException {
    new Program()
        .run("validate", project("contract.qos.incompatible/bad"))
        .expect(1)
        .says(
            "model/chain.xmi:12:3: error: 'Brake_Decision' requests reliability RELIABLE on"
                + " /filter/speed, but 'Speed_Filter' offers BEST_EFFORT")
        .says("[contract.qos.incompatible]")
        .says("at: EventChain[limiter]/data[filtered]")
        .says("model/chain.xmi:8:3");
  }

  @Test
  void theVehicleIsOneMoreSide() throws IOException {
    new Program()
        .run("validate", project("contract.qos.incompatible/bad-from-vehicle"))
        .expect(1)
        .says("but the vehicle offers BEST_EFFORT")
        .says("software-base/signals.json:2:3");
  }

  @Test
  void definitionsOfTheProjectAreKnown() throws IOException {
    Program.Ended ended =
        new Program()
            .run("validate", project("contract.qos.incompatible/good"))
            .expect(1) // It has no scenario.
            .says("26 constraints")
            .says(" message contracts");
    assertFalse(ended.out().contains("[contract."), ended.out());
  }

  @Test
  void nothingIsGeneratedFromAChainThatCannotWork() throws IOException {
    new Program()
        .run("generate", project("contract.field.unset/bad"))
        .expect(1)
        .says("[contract.field.unset]");
  }

  @Test
  void aChainWithoutAProjectIsCheckedAsFarAsItKnowsTheVehicle() {
    Path bad = CASES.resolve("contract.qos.incompatible/bad");
    new Program()
        .run("validate", bad.resolve("chain.xmi"), "--messages", bad.resolve("msg"))
        .expect(1)
        .says("chain.xmi:12:3: error:")
        .says("[contract.qos.incompatible]");
    new Program()
        .run("validate", bad.resolve("chain.xmi"))
        .expect(1)
        .says("[contract.message.unknown]");
    Path unknownVehicle = CASES.resolve("contract.publisher.missing/bad");
    new Program()
        .run(
            "validate",
            unknownVehicle.resolve("chain.xmi"),
            "--messages",
            unknownVehicle.resolve("msg"))
        .expect(0);
  }

  /** Returns the case as a project with an edited chain. */
  private Path project(String name) throws IOException {
    Path project = folder.resolve("limiter");
    copy(CASES.resolve(name).resolve("signals.json"), project.resolve("software-base"));
    Files.writeString(project.resolve("software-base/components.json"), "[]\n");
    copy(CASES.resolve(name).resolve("chain.xmi"), project.resolve("model"));
    Path messages = CASES.resolve(name).resolve("msg/limiter_msgs/msg");
    try (Stream<Path> files = Files.list(messages)) {
      for (Path file : files.toList()) {
        copy(file, project.resolve("software-base/msg/limiter_msgs/msg"));
      }
    }
    Files.writeString(project.resolve("eventchain.yaml"), "name: limiter\n");
    return project;
  }

  private static void copy(Path file, Path to) throws IOException {
    Files.createDirectories(to);
    Files.copy(file, to.resolve(file.getFileName()));
  }
}
