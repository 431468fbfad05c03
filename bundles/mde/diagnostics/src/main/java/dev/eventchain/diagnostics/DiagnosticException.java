package dev.eventchain.diagnostics;

import java.util.List;
import java.util.function.Supplier;

/**
 * A stage could not make its result, and these findings say why. Findings that still allow a result
 * are part of the result instead.
 */
public final class DiagnosticException extends RuntimeException {

  private static final long serialVersionUID = 1L;

  /** Why there is no result, which decides how a command ends. */
  public enum Reason {
    /** The input was read and found invalid. */
    FINDINGS,
    /** The input could not be read, or the command was used wrongly. */
    INPUT,
    /** This machine lacks something. */
    UNAVAILABLE,
    /** An answer is awaited from outside. */
    WAITING
  }

  private final Reason reason;
  private final transient List<Diagnostic> diagnostics;

  /**
   * Says why there is no result.
   *
   * @param diagnostics the findings, at least one, of which one is an error
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

  /** Why there is no result. */
  public Reason reason() {
    return reason;
  }

  /** What was found, in the order of discovery; at least one. */
  public List<Diagnostic> diagnostics() {
    return diagnostics;
  }

  /** Accompanies an unforeseen failure, and says what it is about. */
  private static final class Place extends RuntimeException {

    private static final long serialVersionUID = 1L;

    private final transient SourceLocation location;

    private Place(SourceLocation location) {
      super("while " + location + " was handled", null, false, false);
      this.location = location;
    }
  }

  /**
   * Does something that is about a place. What goes wrong with it that is not a finding is thrown
   * as it is, and {@link #placeOf} knows the place; the innermost one if there are several.
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

  /** What was handled when a failure happened; {@link SourceLocation#NONE} if unknown. */
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
