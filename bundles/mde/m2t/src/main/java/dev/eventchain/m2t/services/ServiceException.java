package dev.eventchain.m2t.services;

/**
 * Thrown if a call of a Java service has no value. The message starts with the name of the service
 * and gives the reason.
 */
public final class ServiceException extends IllegalArgumentException {
  private static final long serialVersionUID = 1L;

  ServiceException(String message, Throwable cause) {
    super(message, cause);
  }

  public ServiceException(String message) {
    super(message);
  }
}
