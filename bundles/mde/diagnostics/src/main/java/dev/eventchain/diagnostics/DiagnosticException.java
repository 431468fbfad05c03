package dev.eventchain.diagnostics;

import java.util.List;
import java.util.function.Supplier;

/**
 * Thrown when a stage cannot produce its result; the findings give the reasons. Findings that still
 * allow a result are part of the result instead.
 */
public final class DiagnosticException extends RuntimeException {

  private static final long serialVersionUID = 1L;

  /** Reason for the missing result, which decides the exit code of a command. */
  public enum Reason {
    /** Input that was read and found invalid. */
    FINDINGS,
    /** Unreadable input, or wrong use of the command. */
    INPUT,
    /** Prerequisite missing on this machine. */
    UNAVAILABLE,
    /** External answer pending. */
    WAITING
  }

  private final Reason reason;
  private final transient List<Diagnostic> diagnostics;

  /**
   * Creates an exception with findings.
   *
   * @param diagnostics the findings; at least one is an error
   */
  public DiagnosticException(Reason reason, List<Diagnostic> diagnostics) {
    super(summary(diagnostics));
    this.reason = reason;
    this.diagnostics = List.copyOf(diagnostics);
  }

  /** As {@link #DiagnosticException(Reason, List)} with a single finding. */
  public DiagnosticException(Reason reason, Diagnostic diagnostic) {
    this(reason, List.of(diagnostic));
  }

  /** Returns the reason for the missing result. */
  public Reason reason() {
    return reason;
  }

  /** Returns the findings in the order of discovery; at least one. */
  public List<Diagnostic> diagnostics() {
    return diagnostics;
  }

  /** Location of an unforeseen failure, attached as a suppressed exception. */
  private static final class Place extends RuntimeException {

    private static final long serialVersionUID = 1L;

    private final transient SourceLocation location;

    private Place(SourceLocation location) {
      super("while " + location + " was handled", null, false, false);
      this.location = location;
    }
  }

  /**
   * Runs work on a location. Exceptions are rethrown unchanged; for those that are not findings,
   * {@link #placeOf} returns the innermost such location.
   */
  public static <T> T at(SourceLocation place, Supplier<T> work) {
    try {
      return work.get();
    } catch (DiagnosticException e) {
      throw e;
    } catch (RuntimeException | Error e) {
      if (placeOf(e).equals(SourceLocation.NONE)) {
        e.addSuppressed(new Place(place));
      }
      throw e;
    }
  }

  /** As {@link #at(SourceLocation, Supplier)} for work without a result. */
  public static void runAt(SourceLocation place, Runnable work) {
    at(
        place,
        () -> {
          work.run();
          return place;
        });
  }

  /**
   * Returns the location that was being processed at a failure; {@link SourceLocation#NONE} if
   * unknown.
   */
  public static SourceLocation placeOf(Throwable failure) {
    for (Throwable cause = failure; cause != null; cause = cause.getCause()) {
      for (Throwable with : cause.getSuppressed()) {
        if (with instanceof Place place) {
          return place.location;
        }
      }
    }
    return SourceLocation.NONE;
  }

  private static String summary(List<Diagnostic> diagnostics) {
    if (diagnostics.isEmpty()) {
      throw new IllegalArgumentException("a failure needs a finding");
    }
    Diagnostic first = diagnostics.get(0);
    return first.location() + ": " + first.message() + " [" + first.id() + "]";
  }
}
