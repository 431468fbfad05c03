package dev.eventchain.eclipse;

import java.time.Duration;
import org.eclipse.core.runtime.Platform;
import org.eclipse.core.runtime.preferences.AbstractPreferenceInitializer;
import org.eclipse.core.runtime.preferences.DefaultScope;
import org.eclipse.core.runtime.preferences.IPreferencesService;

/** The preferences of the plug-in and their defaults. */
public final class Preferences extends AbstractPreferenceInitializer {

  /** The processor time that a constraint may take on a model, in seconds. */
  public static final String TIME_LIMIT = "timeLimit";

  /** Path of the program {@code eventchain}; empty for the one on the search path. */
  public static final String PROGRAM = "program";

  private static final int TIME_LIMIT_DEFAULT = 30;

  @Override
  public void initializeDefaultPreferences() {
    DefaultScope.INSTANCE.getNode(EventchainCore.ID).putInt(TIME_LIMIT, TIME_LIMIT_DEFAULT);
    DefaultScope.INSTANCE.getNode(EventchainCore.ID).put(PROGRAM, "");
  }

  static Duration timeLimit() {
    IPreferencesService service = Platform.getPreferencesService();
    int seconds = service.getInt(EventchainCore.ID, TIME_LIMIT, TIME_LIMIT_DEFAULT, null);
    return Duration.ofSeconds(Math.max(1, seconds));
  }

  /** Returns the configured path of the program; empty if there is none. */
  static String program() {
    return Platform.getPreferencesService().getString(EventchainCore.ID, PROGRAM, "", null).strip();
  }
}
