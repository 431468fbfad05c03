package dev.eventchain.maven.samples;

/** Java services of the template in the sample {@code generate}. */
public final class Headings {

  private Headings() {}

  /** Returns a heading as a sentence. */
  public static String sentence(String heading) {
    return heading + ".";
  }
}
