/** The Python environment, and the confined process in which foreign Python runs. */
package dev.eventchain.sandbox;
