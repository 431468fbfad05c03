package dev.eventchain.pipeline.search;

import java.util.SplittableRandom;

/**
 * One of several searches for small values of a function on the unit cube. What it asks for depends
 * on its own answers only. It begins anew at another place where its method expects nothing better,
 * and after each find.
 */
public final class IndependentSearch {

  /** Questions for each evaluation: a space of few values has the same answer to many. */
  private static final int QUESTIONS = 20;

  /**
   * Value of a function at a point.
   *
   * @param evaluated whether it took an evaluation; false where the value was known, or has not to
   *     be known
   * @param isFind whether the search may go on elsewhere
   */
  public record Answer(double value, boolean evaluated, boolean isFind) {}

  /** A function that is searched. */
  public interface Function {

    /** Returns whether the search goes on. */
    boolean isOpen();

    /** Returns what is at a point; each coordinate is from 0 to below 1. */
    Answer at(double[] point);
  }

  /** The end of a run of the method, from within the function. */
  private static final class RunEndedException extends RuntimeException {

    private static final long serialVersionUID = 1L;

    RunEndedException() {
      super("", null, false, false);
    }
  }

  private final SearchMethod method;
  private final Function function;
  private final SplittableRandom random;
  private int evaluations;
  private int questions;

  /**
   * Creates a search.
   *
   * @param evaluations how many it has
   */
  public IndependentSearch(SearchMethod method, Function function, int evaluations, long seed) {
    this.method = method;
    this.function = function;
    this.evaluations = evaluations;
    this.questions = evaluations * QUESTIONS;
    this.random = new SplittableRandom(seed);
  }

  /** Searches, from a point on, until all evaluations are used. */
  public void run(double[] start) {
    double[] next = start;
    while (isOpen()) {
      try {
        method.run(this::value, next, random.split());
      } catch (RunEndedException e) {
        // Here or elsewhere, the next run says.
      }
      next = random.doubles(start.length).toArray();
    }
  }

  private boolean isOpen() {
    return evaluations > 0 && questions > 0 && function.isOpen();
  }

  private double value(double[] point) {
    if (!isOpen()) {
      throw new RunEndedException();
    }
    Answer answer = function.at(point.clone());
    questions--;
    evaluations -= answer.evaluated() ? 1 : 0;
    if (answer.isFind()) {
      throw new RunEndedException();
    }
    return answer.value();
  }
}
