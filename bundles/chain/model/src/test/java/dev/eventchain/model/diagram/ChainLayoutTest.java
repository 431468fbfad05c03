package dev.eventchain.model.diagram;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.model.diagram.ChainDiagram.Area;
import dev.eventchain.model.diagram.ChainDiagram.Box;
import dev.eventchain.model.diagram.ChainDiagram.Kind;
import dev.eventchain.model.diagram.ChainDiagram.Line;
import dev.eventchain.model.diagram.ChainDiagram.LineKind;
import dev.eventchain.model.diagram.ChainDiagram.Point;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.model.eventchain.SoftwareNode;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;

class ChainLayoutTest {

  static final TextSizes SIZES =
      new TextSizes() {
        @Override
        public int width(String text, boolean title) {
          return text.length() * (title ? 8 : 7);
        }

        @Override
        public int height(boolean title) {
          return title ? 18 : 16;
        }
      };

  private static ChainDiagram layout(EventChain chain) {
    ChainDiagram diagram = ChainLayout.of(chain, SIZES);
    check(diagram);
    return diagram;
  }

  /** Checks the invariants of every diagram. */
  private static void check(ChainDiagram diagram) {
    SortedMap<Integer, List<Area>> rows = new TreeMap<>();
    for (Box box : diagram.boxes()) {
      List<Area> all = new ArrayList<>(box.bars());
      all.add(box.area());
      for (Area area : all) {
        assertTrue(area.x() >= 0 && area.y() >= 0, area::toString);
        assertTrue(area.x() + area.width() <= diagram.width(), area::toString);
        assertTrue(area.y() + area.height() <= diagram.height(), area::toString);
        assertFree(rows, area, List.of());
        rows.computeIfAbsent(area.y(), key -> new ArrayList<>()).add(area);
      }
      checkTexts(box);
    }
    diagram.lines().forEach(line -> checkLine(diagram, line, rows));
  }

  /** Checks that an area overlaps allowed ones only; boxes are at most 100 high. */
  private static void assertFree(
      SortedMap<Integer, List<Area>> rows, Area area, List<Area> allowed) {
    for (List<Area> row : rows.subMap(area.y() - 100, area.y() + area.height()).values()) {
      for (Area other : row) {
        assertTrue(
            !overlap(area, other) || allowed.contains(other), () -> area + " overlaps " + other);
      }
    }
  }

  private static boolean overlap(Area a, Area b) {
    return a.x() < b.x() + b.width()
        && b.x() < a.x() + a.width()
        && a.y() < b.y() + b.height()
        && b.y() < a.y() + a.height();
  }

  private static void checkTexts(Box box) {
    int height = box.texts().stream().mapToInt(text -> SIZES.height(text.title())).sum();
    assertTrue(height <= box.area().height() && box.area().height() < 100, box::toString);
    box.texts().forEach(t -> assertTrue(t.width() <= box.area().width(), box::toString));
  }

  private static void checkLine(
      ChainDiagram diagram, Line line, SortedMap<Integer, List<Area>> rows) {
    Box from = diagram.boxes().get(line.from());
    Box to = diagram.boxes().get(line.to());
    Point first = line.points().get(0);
    Point last = line.points().get(line.points().size() - 1);
    assertTrue(
        touches(line.isBack() ? to : from, line.isBack() ? last : first, true), () -> "" + line);
    assertTrue(
        touches(line.isBack() ? from : to, line.isBack() ? first : last, false), () -> "" + line);
    List<Area> ends = List.of(from.area(), to.area());
    for (int i = 1; i < line.points().size(); i++) {
      Point a = line.points().get(i - 1);
      Point b = line.points().get(i);
      assertTrue(line.isBack() ? b.y() < a.y() : b.y() > a.y(), () -> "" + line);
      int top = Math.min(a.y(), b.y());
      int height = Math.abs(a.y() - b.y());
      if (a.x() == b.x()) {
        assertFree(rows, new Area(a.x(), top, 1, height), List.of());
      } else {
        assertFree(rows, new Area(0, top, diagram.width(), height), ends);
      }
    }
  }

  /** Returns whether a line ends at a side of a box or at its bar. */
  private static boolean touches(Box box, Point point, boolean lowerSide) {
    List<Area> areas = new ArrayList<>(box.bars());
    areas.add(box.area());
    return areas.stream()
        .anyMatch(
            area ->
                point.x() >= area.x()
                    && point.x() <= area.x() + area.width()
                    && point.y() == area.y() + (lowerSide ? area.height() : 0));
  }

  private static String shape(ChainDiagram diagram) {
    return diagram.boxes().stream().map(box -> box.name() + box.area() + box.bars()).toList()
        + diagram.lines().toString();
  }

  private static Box box(ChainDiagram diagram, String name) {
    return diagram.boxes().stream().filter(box -> box.name().equals(name)).findFirst().get();
  }

  @Test
  void drawsWhatComesFromOutsideAtTheTopAndWhatLeavesAtTheBottom() {
    ChainDiagram diagram = layout(Chains.of("in > a", "a late > b", "b > c", "> c2", "c > out"));
    assertEquals(Kind.SIGNAL_IN, box(diagram, "/in").kind());
    assertEquals(Kind.SIGNAL_OUT, box(diagram, "/out").kind());
    assertEquals(Kind.TOPIC, box(diagram, "/a").kind());
    for (Box box : diagram.boxes()) {
      assertTrue(middle(box) >= middle(box(diagram, "/in")) - 1, box::toString);
      assertTrue(middle(box) <= middle(box(diagram, "/out")) + 1, box::toString);
    }
    assertEquals(middle(box(diagram, "/in")), middle(box(diagram, "/late")));
    assertEquals(middle(box(diagram, "/out")), middle(box(diagram, "/c2")));
  }

  private static int middle(Box box) {
    return box.area().center().y();
  }

  @Test
  void drawsBarsWhereTheFlowForksAndJoins() {
    ChainDiagram diagram = layout(Chains.of("> a", "a > b c", "a >", "b c > d"));
    assertEquals(1, box(diagram, "/a").bars().size());
    assertEquals(1, box(diagram, "N1").bars().size());
    assertTrue(box(diagram, "N1").bars().get(0).y() > box(diagram, "N1").area().y());
    assertEquals(1, box(diagram, "N3").bars().size());
    assertTrue(box(diagram, "N3").bars().get(0).y() < box(diagram, "N3").area().y());
    assertEquals(List.of(), box(diagram, "/b").bars());
  }

  @Test
  void drawsASignalThatLeavesAlthoughItIsReadTwice() {
    EventChain chain = Chains.of("> a", "a >");
    chain.getData().get(0).setExternal(true);
    List<Kind> kinds = layout(chain).boxes().stream().map(Box::kind).toList();
    assertEquals(List.of(Kind.COMPONENT, Kind.COMPONENT, Kind.TOPIC, Kind.SIGNAL_OUT), kinds);
  }

  @Test
  void leadsOnlyLinesAgainstTheOrderUpwards() {
    ChainDiagram diagram = layout(Chains.of("in c > a", "a > b", "b > c"));
    List<Line> back = diagram.lines().stream().filter(Line::isBack).toList();
    assertEquals(1, back.size());
    assertEquals("/c", diagram.boxes().get(back.get(0).from()).name());
    assertEquals("N0", diagram.boxes().get(back.get(0).to()).name());
  }

  @Test
  void drawsAComponentThatReadsWhatItWrites() {
    ChainDiagram diagram = layout(Chains.of("a > a"));
    assertEquals(2, diagram.boxes().size());
    assertEquals(List.of(false, true), diagram.lines().stream().map(Line::isBack).toList());
  }

  @Test
  void aChainInTheWrongOrderStillRunsDown() {
    ChainDiagram diagram = layout(Chains.of("b > c", "a > b", "> a"));
    assertTrue(diagram.lines().stream().noneMatch(Line::isBack));
  }

  @Test
  void drawsNextStepsWhereNoDataFlows() {
    EventChain chain = Chains.of("> a", "a >", ">");
    chain.getSoftware().get(0).setNextstep(chain.getSoftware().get(1));
    chain.getSoftware().get(1).setNextstep(chain.getSoftware().get(2));
    List<Line> steps =
        layout(chain).lines().stream().filter(line -> line.kind() == LineKind.NEXT_STEP).toList();
    assertEquals(1, steps.size());
    assertEquals(2, steps.get(0).to());
  }

  @Test
  void drawsNothingAndOneAndThoseWithoutNames() {
    assertEquals(List.of(), layout(Chains.of()).boxes());
    EventChain chain = Chains.of(">");
    SoftwareNode node = chain.getSoftware().get(0);
    node.setName(null);
    node.setFrequency(33.30);
    ChainDiagram diagram = layout(chain);
    assertEquals("(no name)", diagram.boxes().get(0).texts().get(0).text());
    assertEquals("33.3 Hz \u00b7 existing", diagram.boxes().get(0).texts().get(1).text());
    node.setFrequency(1e300);
    assertEquals("1.0E300 Hz \u00b7 existing", layout(chain).boxes().get(0).facts());
    node.setFrequency(200);
    assertEquals("200 Hz \u00b7 existing", layout(chain).boxes().get(0).facts());
  }

  @Test
  void keepsComponentsOfOneNameApart() {
    EventChain chain = Chains.of("> a", "a >");
    chain.getSoftware().forEach(node -> node.setName("Same"));
    ChainDiagram diagram = layout(chain);
    assertEquals(3, diagram.boxes().size());
    assertEquals(chain.getSoftware().get(1), diagram.boxes().get(1).element());
  }

  @Test
  void cutsLongNamesInTheMiddle() {
    EventChain chain = Chains.of("> a");
    chain.getSoftware().get(0).setName("First" + "x".repeat(5000) + "Last");
    Box box = layout(chain).boxes().get(0);
    assertTrue(box.area().width() < 400);
    assertTrue(box.texts().get(0).text().matches("Firstx+\u2026x+Last"), box.toString());
  }

  @Test
  void placesFiveHundredComponents() {
    String[] line = new String[500];
    String[] shuffled = new String[500];
    for (int i = 0; i < 500; i++) {
      line[i] = "t" + i + " speed s" + i + " > t" + (i + 1);
      shuffled[i] = "t" + (i * 7 + 3) % 500 + " t" + i * 31 % 400 + " > t" + (i * 13 + 1) % 500;
    }
    assertEquals(500 + 501 + 500 + 1, layout(Chains.of(line)).boxes().size());
    assertTrue(layout(Chains.of(shuffled)).boxes().size() > 900);
    String[] loose = new String[500];
    Arrays.fill(loose, ">");
    ChainDiagram diagram = layout(Chains.of(loose));
    assertTrue(diagram.width() < 6000 && diagram.height() < 6000, diagram.width() + " wide");
  }

  @Test
  void holdsForAnyChain() {
    boolean anyBack = false;
    for (long seed = 0; seed < 2000; seed++) {
      ChainDiagram diagram = layout(Chains.random(seed));
      assertEquals(shape(diagram), shape(layout(Chains.random(seed))));
      anyBack |= diagram.lines().stream().anyMatch(Line::isBack);
    }
    assertTrue(anyBack);
  }
}
