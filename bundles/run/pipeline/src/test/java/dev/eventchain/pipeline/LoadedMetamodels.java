package dev.eventchain.pipeline;

import dev.eventchain.check.ChainModel;
import org.junit.jupiter.api.extension.Extension;

/** Loads the metamodels before any test starts, since two threads that load them can lock up. */
public final class LoadedMetamodels implements Extension {

  static {
    ChainModel.loadMetamodels();
  }
}
