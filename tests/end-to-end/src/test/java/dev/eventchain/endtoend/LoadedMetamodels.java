package dev.eventchain.endtoend;

import dev.eventchain.check.ChainModel;
import org.junit.jupiter.api.extension.Extension;

/** Loads the metamodels of the tests before any of them starts; the program has its own classes. */
public final class LoadedMetamodels implements Extension {

  static {
    ChainModel.loadMetamodels();
  }
}
