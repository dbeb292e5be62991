//! What menus say of a built-in scene.

/// Title and description of a built-in scene.
#[derive(Debug, Clone, Copy)]
pub struct Info {
    /// Its id.
    pub id: &'static str,
    /// `parking`, `grid`, `tight`, `paper`, `moving`, `road` or `figures`.
    pub group: &'static str,
    /// Its name in English and Chinese.
    pub title: [&'static str; 2],
    /// The question it asks, in English and Chinese.
    pub question: [&'static str; 2],
}

/// An entry of a menu; a function, because tables of scenes are constants.
pub(super) const fn info(
    id: &'static str,
    group: &'static str,
    title: [&'static str; 2],
    question: [&'static str; 2],
) -> Info {
    Info { id, group, title, question }
}
