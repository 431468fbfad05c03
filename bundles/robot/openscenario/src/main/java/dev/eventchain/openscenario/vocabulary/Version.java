package dev.eventchain.openscenario.vocabulary;

/**
 * A version of OpenSCENARIO XML, 1.0 to 1.3.
 *
 * @param minor the number after the dot
 */
public record Version(int minor) implements Comparable<Version> {

  public static final Version FIRST = new Version(0);
  public static final Version LATEST = new Version(3);

  /** Returns the version of a text such as {@code 1.2}. */
  static Version parse(String text) {
    return new Version(Integer.parseInt(text.substring(text.indexOf('.') + 1)));
  }

  /** Returns whether it is this version or a later one. */
  public boolean isSince(Version other) {
    return compareTo(other) >= 0;
  }

  @Override
  public int compareTo(Version other) {
    return Integer.compare(minor, other.minor);
  }

  @Override
  public String toString() {
    return "1." + minor;
  }
}
