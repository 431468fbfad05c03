package dev.eventchain.project;

import static org.junit.jupiter.api.Assertions.assertEquals;

import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.model.WrittenRequirement;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Users copy the example, so it must have no findings. */
class ExampleTest {

  private static final Path EXAMPLE = Path.of("../../../examples/aeb");

  @Test
  void theSoftwareBaseIsSound() {
    SoftwareBase base = SoftwareBase.read(EXAMPLE.resolve("software-base"));
    assertEquals(List.of(), base.diagnostics());
    assertEquals(
        List.of("ObjectDetection", "Carla_Vehicle_Control", "Lane_Keeping", "Speed_Limit_Display"),
        base.components().stream().map(SoftwareBase.Component::name).toList());
  }

  @Test
  void theDesignRulesHaveTheirIds() {
    Requirements rules = Requirements.read(SourceText.read(EXAMPLE.resolve("design-rules.md")));
    assertEquals(List.of(), rules.diagnostics());
    assertEquals(
        List.of("DR-1", "DR-2", "DR-3"),
        rules.items().stream().map(WrittenRequirement::id).toList());
  }
}
