package dev.eventchain.retrieval;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.catalogue.SignalCatalogue;
import dev.eventchain.catalogue.signal.CatalogueSource;
import dev.eventchain.retrieval.Shortlist.Entry;
import dev.eventchain.retrieval.Shortlist.Text;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;

/** Tests of the list that a design is offered. */
class ShortlistTest {

  private static final SignalCatalogue WHOLE =
      SignalCatalogue.read(
          new CatalogueSource(
              Path.of("../../../examples/child-presence/catalogue/vss.json"),
              List.of(),
              Optional.empty()));
  private static final String SEATS =
      "Vehicle.Cabin.Seat.{Row1,Row2}.{DriverSide,Middle,PassengerSide}.OccupancyStatus";
  private static final String HORN = "Vehicle.Body.Horn.IsActive";
  private static final List<Text> TEXTS =
      List.of(
          new Text("CP-1", "The horn shall sound when a child is left behind.", true),
          new Text("CP-2", "The warning shall end when a door is opened.", true));

  @Test
  void joinsWhatEachTextNeeds() {
    List<Entry> entries = Shortlist.of(WHOLE, TEXTS, 16, List.of(), List.of()).entries();
    assertEquals(16, entries.size());
    assertEquals("CP-1", entry(HORN, entries).because());
    assertEquals("CP-1", entry(SEATS, entries).because());
    assertEquals(6, entry(SEATS, entries).group().signals().size());
    assertTrue(
        entries.stream()
            .anyMatch(
                it ->
                    it.group()
                        .path()
                        .endsWith("Door.{Row1,Row2}.{DriverSide,PassengerSide}.IsOpen")));
    for (int i = 1; i < entries.size(); i++) {
      assertTrue(entries.get(i - 1).score() >= entries.get(i).score());
    }
  }

  @Test
  void aTextMayBeLong() {
    StringBuilder text = new StringBuilder("The horn sounds");
    for (int i = 0; i < 600; i++) {
      text.append(" word").append((char) ('a' + i % 26)).append((char) ('a' + i / 26));
    }
    List<Text> texts = List.of(new Text("CP-1", text.toString(), true));
    List<Entry> entries = Shortlist.of(WHOLE, texts, 16, List.of(), List.of()).entries();
    assertEquals("CP-1", entry(HORN, entries).because());
  }

  @Test
  void givesTheSameListAgain() {
    assertEquals(
        Shortlist.of(WHOLE, TEXTS, 16, List.of(), List.of()),
        Shortlist.of(WHOLE, TEXTS, 16, List.of(), List.of()));
  }

  @Test
  void keepsWhatIsPinnedAndLeavesOutWhatIsExcluded() {
    List<String> pinned = List.of("Vehicle.Speed", "Vehicle.Trailer");
    List<String> excluded = List.of(HORN, "Vehicle.Cabin.Seat.Row1");
    List<Entry> entries = Shortlist.of(WHOLE, TEXTS, 3, pinned, excluded).entries();
    assertEquals(3, entries.size());
    assertEquals(List.of(true, true, false), entries.stream().map(Entry::isPinned).toList());
    assertEquals(
        1,
        Shortlist.of(WHOLE, TEXTS, 40, List.of(), excluded).entries().stream()
            .filter(
                it -> it.group().path().contains("Seat.Row2.{DriverSide,Middle,PassengerSide}.Occ"))
            .count());
    assertTrue(entries.stream().noneMatch(it -> it.group().path().equals(HORN)));
    assertEquals(2, Shortlist.of(WHOLE, TEXTS, 1, pinned, List.of()).entries().size());
  }

  @Test
  void hasNothingForWordsThatNoSignalHas() {
    List<Text> strange = List.of(new Text("X-1", "Colourless zeugmas shall frobnicate.", true));
    assertEquals(
        List.of(),
        Shortlist.of(WHOLE, strange, 16, List.of(), List.of()).entries().stream()
            .map(it -> it.group().path())
            .filter(path -> !path.contains("Color"))
            .toList());
  }

  /** Software that is there counts half as much as what is asked for. */
  @Test
  void prefersWhatIsRequired() {
    Text horn = new Text("Horn_Control", TEXTS.get(0).text(), false);
    List<Entry> entries =
        Shortlist.of(WHOLE, List.of(TEXTS.get(1), horn), 1, List.of(), List.of()).entries();
    assertEquals("CP-2", entries.get(0).because());
  }

  private static Entry entry(String path, List<Entry> entries) {
    return entries.stream().filter(it -> it.group().path().equals(path)).findFirst().orElseThrow();
  }
}
