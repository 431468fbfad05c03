package dev.eventchain.roads.reader;

import dev.eventchain.roads.geometry.Cubic;
import dev.eventchain.roads.geometry.PlanCurve;
import dev.eventchain.roads.geometry.PlanCurves;
import dev.eventchain.roads.geometry.PlanPoint;
import dev.eventchain.roads.geometry.Profile;
import dev.eventchain.roads.geometry.ReferenceLine;
import dev.eventchain.roads.xml.CheckedElement;
import dev.eventchain.roads.xml.Problems;
import dev.eventchain.roads.xml.XmlRules;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** Reader of a road's plan view. */
final class PlanReader {

  /**
   * Distance between the end of a curve and the start of the next one that is no rounding, in m.
   */
  private static final double GAP = 0.05;

  /** Difference between a road's length and its geometries' that comes from whole metres, in m. */
  private static final double ROUNDED_LENGTH = 0.5;

  /** Turns of a curve beyond which it is no road: a hundred times around. */
  private static final double MOST_TURNED = 200 * Math.PI;

  private static final List<String> KINDS = List.of("line", "arc", "spiral", "poly3", "paramPoly3");

  private final Problems problems;

  PlanReader(Problems problems) {
    this.problems = problems;
  }

  /** Reads a line; empty if it has problems, which are reported. */
  Optional<ReferenceLine> read(CheckedElement road, double length) {
    int before = problems.errors();
    List<CheckedElement> elements =
        road.requiredChild("planView").map(plan -> plan.children("geometry")).orElse(List.of());
    if (elements.isEmpty() && problems.errors() == before) {
      road.child("planView").ifPresent(plan -> plan.requiredChild("geometry"));
    }
    new Records(problems).requireOrder(elements, "s");
    List<ReferenceLine.Piece> pieces = new ArrayList<>();
    elements.forEach(element -> piece(element).ifPresent(pieces::add));
    if (problems.errors() > before) {
      return Optional.empty();
    }
    requireContinuous(elements, pieces);
    requireLength(road, elements, pieces, length);
    return Optional.of(new ReferenceLine(pieces, length));
  }

  private Optional<ReferenceLine.Piece> piece(CheckedElement element) {
    int before = problems.errors();
    double start = element.number("s");
    double x = element.number("x");
    double y = element.number("y");
    double heading = element.number("hdg");
    double length = element.number("length");
    if (length <= 0) {
      problems.add(
          RoadRules.LENGTH,
          element.at("length"),
          "The geometry is " + length + " m long.",
          "Remove the geometry, or export the file again.");
    }
    Optional<CheckedElement> curve =
        element.children().stream().filter(child -> KINDS.contains(child.name())).findFirst();
    if (curve.isEmpty()) {
      problems.add(
          XmlRules.ELEMENT_MISSING,
          element,
          "The geometry has no curve.",
          "Add one of `" + String.join("`, `", KINDS) + "`.");
    }
    if (problems.errors() > before) {
      return Optional.empty();
    }
    return curve(curve.get(), length)
        .map(made -> new ReferenceLine.Piece(start, x, y, heading, length, made));
  }

  private Optional<PlanCurve> curve(CheckedElement element, double length) {
    int before = problems.errors();
    PlanCurve curve =
        switch (element.name()) {
          case "line" -> new PlanCurve.Line();
          case "arc" -> new PlanCurve.Arc(bounded(element, "curvature", length));
          case "spiral" -> spiral(element, length);
          case "poly3" -> poly3(element, length);
          default -> parametric(element, length);
        };
    if (problems.errors() > before) {
      return Optional.empty();
    }
    double own = PlanCurves.ownLength(curve, length);
    if (Math.abs(own - length) > Math.max(0.1, 0.01 * length)) {
      problems.add(
          RoadRules.LENGTH_UNEQUAL,
          element,
          "The curve is " + rounded(own) + " m long, and its geometry says " + length + " m.",
          "The curve is used, and s stretched. Correct the length or the coefficients.");
    }
    return Optional.of(curve);
  }

  private PlanCurve spiral(CheckedElement element, double length) {
    double start = bounded(element, "curvStart", length);
    double end = bounded(element, "curvEnd", length);
    return Double.isNaN(start + end) ? new PlanCurve.Line() : PlanCurves.spiral(start, end, length);
  }

  private double bounded(CheckedElement element, String attribute, double length) {
    double curvature = element.number(attribute);
    if (Math.abs(curvature) * length > MOST_TURNED) {
      problems.add(
          XmlRules.VALUE,
          element.at(attribute),
          "The curvature " + curvature + "/m turns more than a hundred times on " + length + " m.",
          "Curvatures are 1 by the radius in m.");
      return Double.NaN;
    }
    return curvature;
  }

  private PlanCurve poly3(CheckedElement element, double length) {
    Cubic v = RoadReader.cubic(element);
    return isFinite(v) ? PlanCurves.cubic(v, length) : new PlanCurve.Line();
  }

  private PlanCurve parametric(CheckedElement element, double length) {
    Cubic u = cubic(element, "U");
    Cubic v = cubic(element, "V");
    String range = element.choice("pRange", List.of("normalized", "arcLength"), value -> value);
    if (!isFinite(u) || !isFinite(v)) {
      return new PlanCurve.Line();
    }
    double end = range.equals("arcLength") ? length : 1;
    PlanCurve curve = PlanCurves.parametric(u, v, end, length);
    if (PlanCurves.ownLength(curve, length) < Profile.ROUNDING) {
      problems.add(
          RoadRules.LENGTH,
          element,
          "The curve does not move.",
          "Correct the coefficients, or export the file again.");
    }
    return curve;
  }

  private static Cubic cubic(CheckedElement element, String suffix) {
    return new Cubic(
        element.number("a" + suffix),
        element.number("b" + suffix),
        element.number("c" + suffix),
        element.number("d" + suffix));
  }

  private static boolean isFinite(Cubic cubic) {
    return Double.isFinite(cubic.a() + cubic.b() + cubic.c() + cubic.d());
  }

  private void requireContinuous(List<CheckedElement> elements, List<ReferenceLine.Piece> pieces) {
    for (int i = 1; i < pieces.size(); i++) {
      ReferenceLine.Piece last = pieces.get(i - 1);
      ReferenceLine.Piece next = pieces.get(i);
      PlanPoint end = last.at(last.length());
      PlanPoint start = next.at(0);
      double gap = StrictMath.hypot(end.x() - start.x(), end.y() - start.y());
      double along = next.start() - last.start() - last.length();
      if (gap > GAP || Math.abs(along) > GAP) {
        problems.add(
            RoadRules.GAP,
            elements.get(i),
            gap > GAP
                ? "The geometry begins " + rounded(gap) + " m from where the last one ends."
                : "The geometry begins "
                    + rounded(along)
                    + " m of s behind the end of the last one.",
            "Geometries have to follow each other without gaps: export the file again.");
      }
    }
  }

  private void requireLength(
      CheckedElement road,
      List<CheckedElement> elements,
      List<ReferenceLine.Piece> pieces,
      double length) {
    double start = pieces.get(0).start();
    if (start > Profile.ROUNDING) {
      problems.add(
          RoadRules.GAP,
          elements.get(0),
          "The first geometry begins at s = " + start + ".",
          "The first geometry begins at 0.");
    }
    ReferenceLine.Piece last = pieces.get(pieces.size() - 1);
    double end = last.start() + last.length();
    double unequal = Math.abs(end - length);
    if (length > 0 && unequal > GAP) {
      problems.add(
          unequal > ROUNDED_LENGTH ? RoadRules.LENGTH : RoadRules.LENGTH_UNEQUAL,
          road.at("length"),
          "The road is " + length + " m long, and its geometries end at " + rounded(end) + " m.",
          "Write the sum of the geometries' lengths.");
    }
  }

  private static double rounded(double value) {
    return Math.round(value * 1000) / 1000.0;
  }
}
