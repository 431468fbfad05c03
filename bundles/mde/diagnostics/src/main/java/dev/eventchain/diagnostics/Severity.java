package dev.eventchain.diagnostics;

/** How bad a finding is, worst first. Only {@link #ERROR} makes a command fail. */
public enum Severity {
  ERROR,
  WARNING,
  INFO;

  /** The word that people read. */
  @Override
  public String toString() {
    return switch (this) {
      case ERROR -> "error";
      case WARNING -> "warning";
      case INFO -> "info";
    };
  }
}
