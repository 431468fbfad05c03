package dev.eventchain.simulation.coverage;

import java.util.List;

/**
 * The values that a signal has had in all scenarios without a fault: a field of a topic of the
 * chain, or of the elements of a list.
 *
 * @param topic the full name of the topic
 * @param path the path of the field; {@code distance[]} or {@code objects[].distance} for the
 *     elements of a list
 * @param unit its unit; empty if none is stated
 * @param kind the kind of its values
 * @param writer the component that writes it; empty if it comes from outside
 * @param least the smallest finite number, or the smallest number of elements; NaN if there was
 *     none
 * @param most the largest finite number, or the largest number of elements; NaN if there was none
 * @param seen the truth values, or the names of values, that it had
 * @param missing those that it never had
 * @param episodes the largest number of its episodes in a scenario; 0 where it has none
 * @param gaps what it has not shown, although it might
 */
public record SignalCoverage(
    String topic,
    String path,
    String unit,
    Kind kind,
    String writer,
    double least,
    double most,
    List<String> seen,
    List<String> missing,
    int episodes,
    List<Gap> gaps) {

  /** Kinds of signals. */
  public enum Kind {
    /** True or false; an episode is a time in which it is true. */
    TRUTH,
    /** A number; an episode is a time away from its safe value, or from 0, if it ever rests. */
    NUMBER,
    /** One of several values with names; an episode is a time away from the first one. */
    NAMED,
    /** A list of any length. */
    LIST
  }

  /** Kinds of gaps. */
  public enum Missing {
    /** A value that it never had. */
    VALUE,
    /** An episode after another one. */
    AGAIN,
    /** An element of a list, or one more than one. */
    ELEMENT,
    /** The other sign, or what its counterpart on the other side has. */
    SIDE
  }

  /**
   * Something that no scenario shows of the signal.
   *
   * @param words what, after "no scenario shows"
   */
  public record Gap(Missing kind, String words) {}

  /** Copies the lists. */
  public SignalCoverage {
    seen = List.copyOf(seen);
    missing = List.copyOf(missing);
    gaps = List.copyOf(gaps);
  }

  /** Returns its name, as formulas have it. */
  public String name() {
    return topic + "." + path;
  }

  /** Returns the values that it had, in words. */
  public String shown() {
    return switch (kind) {
      case TRUTH, NAMED -> String.join(", ", seen);
      case NUMBER -> least <= most ? Figures.range(this) : "no number";
      case LIST -> Figures.range(this) + (most == 1.0 ? " element" : " elements");
    };
  }

  /** Returns whether it is that of the elements of a list. */
  public boolean isOfElements() {
    return path.contains("[]");
  }

  /** Returns whether it comes from outside of the chain. */
  public boolean isInput() {
    return writer.isEmpty();
  }

  /** Returns a copy with what it has not shown. */
  SignalCoverage withGaps(List<Gap> found) {
    return new SignalCoverage(
        topic, path, unit, kind, writer, least, most, seen, missing, episodes, found);
  }
}
