package dev.eventchain.m2t.services;

/** A call of a Java service has no value; the message says why, after the name of the service. */
public final class ServiceException extends IllegalArgumentException {
  private static final long serialVersionUID = 1L;

  ServiceException(String message, Throwable cause) {
    super(message, cause);
  }

  public ServiceException(String message) {
    super(message);
  }
}
