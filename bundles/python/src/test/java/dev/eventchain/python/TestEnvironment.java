package dev.eventchain.python;

/** The environment of this machine, found once. */
final class TestEnvironment {

  static final PythonEnvironment PYTHON = PythonEnvironment.ensure(line -> {});

  private TestEnvironment() {}
}
