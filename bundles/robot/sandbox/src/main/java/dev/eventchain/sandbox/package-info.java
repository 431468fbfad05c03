/** The Python environment, and the confined process that runs untrusted Python. */
package dev.eventchain.sandbox;
