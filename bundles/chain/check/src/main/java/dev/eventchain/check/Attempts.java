package dev.eventchain.check;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;

/** Work that continues after a failure, so that all problems are reported together. */
final class Attempts {

  private final List<Diagnostic> problems = new ArrayList<>();

  /** Returns the result of some work; empty if it fails, after collecting its findings. */
  <T> Optional<T> of(Supplier<T> work) {
    try {
      return Optional.of(work.get());
    } catch (DiagnosticException e) {
      problems.addAll(e.diagnostics());
      return Optional.empty();
    }
  }

  /** Returns the distinct problems so far, in their order. */
  List<Diagnostic> problems() {
    return problems.stream().distinct().toList();
  }

  /**
   * Throws if any attempt has failed.
   *
   * @throws DiagnosticException INPUT with all problems
   */
  void refuseProblems() {
    if (!problems.isEmpty()) {
      throw new DiagnosticException(DiagnosticException.Reason.INPUT, problems());
    }
  }
}
