package dev.eventchain.sandbox;

import java.util.List;

/** The environment of this machine, determined once. */
final class TestEnvironment {

  static final PythonEnvironment PYTHON = PythonEnvironment.ensure(line -> {});

  private TestEnvironment() {}

  /**
   * Returns the available ways of confinement; bubblewrap is left out where it does not work, as in
   * the product.
   */
  static List<Confinement> confinements() {
    return Confinement.detect(System.getenv()) == Confinement.BUBBLEWRAP
        ? List.of(Confinement.values())
        : List.of(Confinement.AUDIT_HOOKS);
  }
}
