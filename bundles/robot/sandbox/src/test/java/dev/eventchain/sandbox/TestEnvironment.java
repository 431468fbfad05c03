package dev.eventchain.sandbox;

import java.util.List;

/** The environment of this machine, found once. */
final class TestEnvironment {

  static final PythonEnvironment PYTHON = PythonEnvironment.ensure(line -> {});

  private TestEnvironment() {}

  /** Bubblewrap's tests need bubblewrap; where it does not work the product does not use it. */
  static List<Confinement> confinements() {
    return Confinement.detect(System.getenv()) == Confinement.BUBBLEWRAP
        ? List.of(Confinement.values())
        : List.of(Confinement.AUDIT_HOOKS);
  }
}
