package dev.eventchain.roads.road;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;

/**
 * A traffic sign or light.
 *
 * @param id the id
 * @param name often empty
 * @param dynamic whether it changes, as a traffic light does
 * @param orientation the traffic that it is for
 * @param country the code of the country; empty if the file does not say
 * @param type by the country's catalogue
 * @param subtype by the country's catalogue
 * @param value such as the limit of speed
 * @param unit of the value; empty if the file does not say
 * @param text written on it; often empty
 * @param s at which it applies, in m
 * @param pose of the middle of its bottom, where it stands. Its heading is that of the traffic that
 *     it is for, so its face looks the other way
 * @param width in m; 0 if the file does not say
 * @param height in m; 0 if the file does not say
 * @param lanes the lanes that it is for; empty for all
 */
public record Signal(
    String id,
    String name,
    boolean dynamic,
    Orientation orientation,
    String country,
    String type,
    String subtype,
    OptionalDouble value,
    String unit,
    String text,
    double s,
    Pose pose,
    double width,
    double height,
    Optional<List<Integer>> lanes) {

  /**
   * A signal of another road that also applies here.
   *
   * @param signal the id of the signal
   * @param s where it applies, in m
   * @param t in m
   * @param orientation the traffic that it is for
   * @param lanes the lanes that it is for; empty for all
   */
  public record Reference(
      String signal,
      double s,
      double t,
      Signal.Orientation orientation,
      Optional<List<Integer>> lanes) {}

  /**
   * Signals that change together.
   *
   * @param id the id
   * @param name often empty
   * @param signals the ids of the signals
   */
  public record Controller(String id, String name, List<String> signals) {

    /** Copies the signals. */
    public Controller {
      signals = List.copyOf(signals);
    }
  }

  /** The direction of traffic that something is for. */
  public enum Orientation {
    BOTH("none"),
    ALONG_S("+"),
    AGAINST_S("-");

    private final String spelling;

    Orientation(String spelling) {
      this.spelling = spelling;
    }

    /** Returns its name in OpenDRIVE. */
    public String spelling() {
      return spelling;
    }
  }
}
