package dev.eventchain.openscenario.storyboard;

import static dev.eventchain.openscenario.storyboard.Scenarios.car;
import static dev.eventchain.openscenario.storyboard.Scenarios.placed;
import static dev.eventchain.openscenario.storyboard.Scenarios.privately;
import static dev.eventchain.openscenario.storyboard.Scenarios.run;
import static dev.eventchain.openscenario.storyboard.Scenarios.scenario;
import static dev.eventchain.openscenario.storyboard.Scenarios.state;
import static dev.eventchain.openscenario.storyboard.Scenarios.teleport;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.openscenario.storyboard.world.Pose;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests where positions are. Lanes are 3.5 m wide, the road goes along the x axis. */
class PositionTest {

  private static StoryboardRun other(String position) {
    // The other one comes first, so that it has to wait.
    return run(
        scenario(
            car("Other") + car("Ego") + car("Oncoming"),
            privately("Other", teleport(position))
                + placed("Ego", -1, 100, 10)
                + placed("Oncoming", 1, 400, 10),
            ""));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "<WorldPosition x='7' y='3' h='0.5'/> | 7 | 3 | 0.5",
        "<WorldPosition x='7' y='3'/> | 7 | 3 | 0",
        "<RelativeWorldPosition entityRef='Oncoming' dx='7' dy='1'/> | 407 | 2.75 | 3.141592654",
        "<RelativeObjectPosition entityRef='Oncoming' dx='7' dy='1'/> | 393 | 0.75 | 3.141592654",
        "<RelativeObjectPosition entityRef='Ego' dx='7' dy='1'><Orientation h='0.2'/>"
            + "</RelativeObjectPosition> | 107 | -0.75 | 0.2",
        "<RoadPosition roadId='1' s='50' t='2'/> | 50 | 2 | 0",
        "<RelativeRoadPosition entityRef='Ego' ds='5' dt='1'/> | 105 | -0.75 | 0",
        "<LanePosition roadId='1' laneId='-2' s='50' offset='0.5'/> | 50 | -4.75 | 0",
        "<LanePosition roadId='1' laneId='2' s='50' offset='0.5'/> | 50 | 5.75 | 3.141592654",
        "<LanePosition roadId='1' laneId='2' s='50'><Orientation type='relative' h='0.1'/>"
            + "</LanePosition> | 50 | 5.25 | -3.041592654",
        "<LanePosition roadId='1' laneId='2' s='50'><Orientation type='absolute' h='0.1'/>"
            + "</LanePosition> | 50 | 5.25 | 0.1",
        "<RelativeLanePosition entityRef='Ego' dLane='0' ds='30' offset='0.3'/>"
            + " | 130 | -1.45 | 0",
        "<RelativeLanePosition entityRef='Ego' dLane='-1' ds='-30'/> | 70 | -5.25 | 0",
        "<RelativeLanePosition entityRef='Ego' dLane='1' dsLane='30'/>"
            + " | 130 | 1.75 | 3.141592654",
        "<RelativeLanePosition entityRef='Oncoming' dLane='-1' ds='30' offset='0.5'/>"
            + " | 370 | 4.75 | 3.141592654",
      })
  void isWhereThePositionSays(String position, double x, double y, double heading) {
    Pose pose = state(other(position), "Other").pose();
    assertEquals(x, pose.x(), 1e-9);
    assertEquals(y, pose.y(), 1e-9);
    assertEquals(heading, pose.heading(), 1e-9);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "<RoadPosition roadId='7' s='50' t='2'/> | There is no road '7'.",
        "<RoadPosition roadId='1' s='2001' t='2'/>"
            + " | Road '1' is 2000.0 m long; s = 2001.0 m is not on it.",
        "<LanePosition roadId='1' laneId='3' s='50'/>"
            + " | Road '1' has no lane 3 at s = 50.0 m; it has [2, 1, -1, -2].",
        "<LanePosition roadId='1' laneId='left' s='50'/> | 'left' is not the number of a lane.",
        "<RelativeLanePosition entityRef='Ego' dLane='-2' ds='30'/>"
            + " | There is no lane -2 to the left of the entity's.",
        "<RelativeLanePosition entityRef='Ego' dLane='0' ds='-101'/>"
            + " | The road ends before -101.0 m from the entity.",
        "<GeoPosition latitudeDeg='1' longitudeDeg='1'/>"
            + " | The roads have no georeference, which a GeoPosition needs.",
      })
  void refusesWhatIsNowhere(String position, String message) {
    Diagnostic finding =
        assertThrows(DiagnosticException.class, () -> other(position)).diagnostics().get(0);
    assertEquals("storyboard.place.none", finding.id());
    assertEquals(message, finding.message());
  }

  @Test
  void refusesEntitiesRelativeToEachOther() {
    String init =
        privately("Ego", teleport("<RelativeLanePosition entityRef='Other' dLane='0' ds='1'/>"))
            + privately(
                "Other", teleport("<RelativeLanePosition entityRef='Ego' dLane='0' ds='1'/>"));
    Diagnostic finding =
        assertThrows(
                DiagnosticException.class, () -> run(scenario(car("Ego") + car("Other"), init, "")))
            .diagnostics()
            .get(0);
    assertEquals("storyboard.init.circle", finding.id());
    assertEquals("Ego and Other are placed relative to each other.", finding.message());
  }
}
