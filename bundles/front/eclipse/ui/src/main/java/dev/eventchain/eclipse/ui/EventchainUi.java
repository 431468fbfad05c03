package dev.eventchain.eclipse.ui;

/** The names under which the workbench knows what this bundle contributes. */
public final class EventchainUi {

  /** This bundle. */
  public static final String ID = "dev.eventchain.eclipse.ui";

  private EventchainUi() {}
}
