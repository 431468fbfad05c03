package dev.eventchain.roads.reader;

import dev.eventchain.roads.geometry.Profile;
import dev.eventchain.roads.xml.CheckedElement;
import dev.eventchain.roads.xml.Problems;
import java.util.ArrayList;
import java.util.List;

/** Reader of elements that hold from their s on. */
final class Records {

  private final Problems problems;

  Records(Problems problems) {
    this.problems = problems;
  }

  /**
   * Reads polynomials.
   *
   * @param attribute the name of the attribute with the start
   * @param from s of the place from which the starts are measured
   */
  Profile profile(List<CheckedElement> elements, String attribute, double from) {
    requireOrder(elements, attribute);
    List<Profile.Piece> pieces = new ArrayList<>();
    for (CheckedElement element : elements) {
      double start = from + element.number(attribute);
      pieces.add(new Profile.Piece(start, RoadReader.cubic(element)));
    }
    return new Profile(pieces);
  }

  /** Reports starts that are below 0 or run backwards. */
  void requireOrder(List<CheckedElement> elements, String attribute) {
    double last = 0;
    for (CheckedElement element : elements) {
      double start = element.numberOrNaN(attribute);
      if (Double.isNaN(start)) {
        continue; // Reported where the element is read.
      }
      if (start < last - Profile.ROUNDING) {
        problems.add(
            RoadRules.ORDER,
            element.at(attribute),
            "`" + attribute + "` runs backwards, from " + last + " to " + start + ".",
            "Sort the `" + element.name() + "` elements by `" + attribute + "`, from 0 up.");
      }
      last = Math.max(last, start);
    }
  }
}
