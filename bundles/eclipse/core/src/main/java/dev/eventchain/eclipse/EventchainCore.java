package dev.eventchain.eclipse;

/** The names under which the platform knows what this bundle contributes. */
public final class EventchainCore {

  /** This bundle. */
  public static final String ID = "dev.eventchain.eclipse";

  private EventchainCore() {}
}
