/** Lines of JSON-RPC, requests that can be cancelled, and the session behind them. */
package dev.eventchain.mcp.protocol;
