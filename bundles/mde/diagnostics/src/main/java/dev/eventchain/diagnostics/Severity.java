package dev.eventchain.diagnostics;

/** Severity of a finding, worst first. Only {@link #ERROR} makes a command fail. */
public enum Severity {
  ERROR,
  WARNING,
  INFO;

  /** Returns the display name. */
  @Override
  public String toString() {
    return switch (this) {
      case ERROR -> "error";
      case WARNING -> "warning";
      case INFO -> "info";
    };
  }
}
