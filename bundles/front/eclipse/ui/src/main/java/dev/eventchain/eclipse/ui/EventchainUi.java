package dev.eventchain.eclipse.ui;

/** Identifiers of this bundle's contributions to the workbench. */
public final class EventchainUi {

  /** Identifier of this bundle. */
  public static final String ID = "dev.eventchain.eclipse.ui";

  private EventchainUi() {}
}
