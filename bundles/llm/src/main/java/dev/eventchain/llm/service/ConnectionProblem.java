package dev.eventchain.llm.service;

import java.net.ConnectException;
import java.net.http.HttpTimeoutException;
import java.nio.channels.UnresolvedAddressException;
import java.util.concurrent.CompletionException;
import javax.net.ssl.SSLException;

/** Describes connection problems in words; Java's own messages are often empty. */
final class ConnectionProblem {

  private ConnectionProblem() {}

  static String words(Throwable problem) {
    Throwable cause = problem instanceof CompletionException ? problem.getCause() : problem;
    for (Throwable each = cause; each != null; each = each.getCause()) {
      if (each instanceof UnresolvedAddressException) {
        return "its name is unknown";
      }
    }
    if (cause instanceof HttpTimeoutException) {
      return "it does not answer in time";
    }
    if (cause instanceof ConnectException && cause.getMessage() == null) {
      return "nothing listens there";
    }
    String message =
        cause.getMessage() == null ? cause.getClass().getSimpleName() : cause.getMessage();
    return cause instanceof SSLException ? "no secure connection: " + message : message;
  }
}
