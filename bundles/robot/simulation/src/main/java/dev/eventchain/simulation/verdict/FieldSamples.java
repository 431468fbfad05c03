package dev.eventchain.simulation.verdict;

import java.util.List;

/**
 * Values of a field of a topic in a scenario, one for each message.
 *
 * @param topic the full name of the topic
 * @param path the path of the field
 * @param unit the unit that the model gives it; empty if it gives none
 * @param form what a value is
 * @param samples in the order of time
 */
public record FieldSamples(
    String topic, String path, String unit, Form form, List<Sample> samples) {

  /** Kind of a value. */
  public enum Form {
    NUMBER,
    /** 1 or 0. */
    TRUTH,
    ARRAY,
    /** Elements that are no numbers of their own, such as messages and raw bytes: only counted. */
    LIST
  }

  /**
   * Value of a field in a message; of an array, what its elements have in common.
   *
   * @param time when the message arrived, or was published by a node, in s since the start
   * @param least the number, or the smallest finite element; NaN if there is none
   * @param most the number, or the largest finite element; NaN if there is none
   * @param finite number of finite elements; of a number 1 or 0, of a list 0
   * @param size number of elements; of a number 1
   */
  public record Sample(double time, double least, double most, int finite, int size) {}

  /** Copies the list. */
  public FieldSamples {
    samples = List.copyOf(samples);
  }
}
